// An effect of the catalogue: a named, parameterised edit of the joint's description, and what is known of it.
#pragma once
#include "analysis/diagnosis/fit/joint_edits.h"
#include "analysis/joint/joint.h"

#include <span>
#include <string_view>
#include <vector>

namespace stickslip::gap {

struct FreeForce;

/// Where in the chain of a joint an effect acts; a correction is of a number that the document may have wrong.
enum class Stage { friction, mechanism, actuator, controller, sensor, outside, correction };
std::string_view name_of(Stage stage);

/// What a body feels and does behind a reduction, per effort of the motor and per motion that the encoder sees.
struct Reflected {
    double effort = 1, motion = 1;
};

/// What one of something means for this joint and these records: parameters are fitted in these units, so that a step
/// of one in every parameter is about equally large.
struct Scales {
    double effort = 1;         ///< rms effort that moves the joint
    double velocity = 1;       ///< 95th percentile of |velocity|
    double position = 1;       ///< span of the positions
    double inertia = 1;        ///< of all bodies, as the motor feels it
    double tick = 1e-3;        ///< s
    double duration = 10;      ///< s, longest record
    double peak_effort = 1;    ///< largest |effort|, measured or predicted
    double command = 1;        ///< largest |command|, in the drive's unit
    double coulomb = 0;        ///< nominal Coulomb level, as the motor feels it
    double supply = 1;         ///< V
    Reflected friction, load;  ///< the body that carries main_friction(); the link
};

/// The unit in which a parameter is fitted.
enum class Scale {
    one,
    effort,
    peak_effort,
    velocity,
    position,
    damping,
    stiffness,
    wave_number,
    tick,
    duration,
    inertia,
    angular_frequency,
    command,
    friction_effort,  ///< the same for the body that carries main_friction(), behind its reduction
    friction_velocity,
    friction_position,
    friction_damping,
    friction_stiffness,
    friction_wave_number,
    load_effort,  ///< and for the link
    load_velocity,
    load_position,
    load_damping,
    load_wave_number
};

/// A frequency that is best found on a grid before fitting.
enum class FrequencyGrid {
    none,
    time,             ///< angular frequency in time
    position,         ///< wave number in position
    position_flipped  ///< wave number in position of a term that flips with direction
};

struct EffectParameter {
    std::string_view name;  ///< "c2": the part behind the effect's name
    Quantity quantity;
    Scale scale;
    bool logarithmic = false;  ///< fitted as a logarithm: always positive
    double low, high;          ///< bounds in units of `scale`
    double prior;              ///< what would be usual, in units of `scale`
    std::string_view help;
    FrequencyGrid grid = FrequencyGrid::none;
    bool vanishes = false;  ///< a change from 0; beyond some value nothing is left of what it changes
    /// The misfit jumps at whole units: an effort that arrives just behind a tick is not yet in the row of that tick.
    bool jumps = false;
    bool factor = false;         ///< on a documented number: 1 changes nothing
    bool size = false;           ///< how large the effect is; of forms without one the first parameter is
    double meanwhile = not_set;  ///< in units of `scale`, while the size varies; not set: `prior`, or in proportion
    bool open_above = false;     ///< beyond `high` it does what it does there: that end is no bound
};

/// A form of the catalogue by its names.
struct FormName {
    std::string_view effect, form;
};

/// One way to write the effect down; an effect may have several (Dahl or LuGre bristles).
struct EffectForm {
    std::string_view name;  ///< empty where there is only one
    std::vector<EffectParameter> parameters;
    void (*apply)(Joint& joint, const double* p) = nullptr;           ///< p in SI
    void (*apply_free)(FreeForce& force, const double* p) = nullptr;  ///< in place of apply, for what is no joint's
    std::vector<std::vector<double>> seeds;                           ///< in units of each parameter's scale
    bool (*applies)(const Joint& nominal) = nullptr;                  ///< null: always
    std::size_t own = 0;  ///< the last so many parameters have a value of their own in every record
    bool rough = false;   ///< the misfit is jagged in its parameters: search before descending
    /// Forms that have its first parameters between them, in this order, and with them come near it. What looks like
    /// this form may be one of them; or, of two, both.
    std::vector<FormName> parts{};
    /// Effects whose motion is the very same as one that this form makes with fewer parameters, and that joints do
    /// have: friction whose level alone differs by direction, a base that is tilted.
    std::vector<std::string_view> same_motion{};
    /// Effect of which its last parameter, a logarithm, adds a part: so many times the size of the effect itself.
    std::string_view mixed_with{};
    bool own_number = false;       ///< of another number than the effect's first form, as that of the other body
    bool divides = false;          ///< makes two masses of a joint documented as one: ten times as slow as the others
    bool encoder_on_link = false;  ///< moves the encoder of a joint documented as one mass behind its transmission
    bool effort_alone = false;  ///< moves the joint as a likelier effect does: only a measured effort tells them apart
    /// Of two known masses with backlash: where the link rests within it at the start of an excerpt is not known.
    bool needs_history = false;
    int apart = -1;  ///< parameter of which every seeded value gets a descent of its own; −1: none
};

struct Effect {
    std::string_view name;
    Stage stage = Stage::friction;
    std::string_view form;    ///< formula in words
    std::string_view source;  ///< who described it
    std::vector<std::string_view> confusable;
    std::vector<EffectForm> forms;
    /// The first form with more freedom of shape, its further parameters behind its own. It is not searched for: in a
    /// ladder it takes the place of the first form where it predicts better, so that the name survives another shape.
    std::vector<EffectForm> flexible{};
    bool of_transmission = false;  ///< divides the mass, or edits what lies between two
    bool in_command = false;       ///< a logged command shows it: the audit of the controller judges it
    bool read_off = false;         ///< the readings show it without any fit
    /// Of an actuator, and what a wrong scale of the measured effort looks like, too.
    bool scales_reading = false;
};

/// A factor on a documented number.
EffectParameter factor_on_number(double low, double high, double prior, std::string_view help,
                                 std::string_view name = "factor");

/// The catalogue, in the order of the chain: friction, mechanism, actuator, controller, sensor, outside. Edits that
/// change the model of the joint come after edits of its numbers.
std::span<const Effect> effects();

/// The effect of that name, or nullptr.
const Effect* effect_named(std::string_view name);

/// SI value of one unit of a scale.
double unit_of(Scale scale, const Scales& scales);

/// Forms of a wave over the position with parameters sine, cosine, periods: with its second harmonic, sine and cosine.
EffectForm with_second_harmonic(EffectForm form, void (*apply)(Joint& joint, const double* p));
/// Sine, cosine, periods, and the second harmonic's sine and cosine.
void add_harmonics(PositionRipple& ripple, const double* p);

}  // namespace stickslip::gap
