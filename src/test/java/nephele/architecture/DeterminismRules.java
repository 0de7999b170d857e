package nephele.architecture;

import static com.tngtech.archunit.base.DescribedPredicate.describe;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;

import com.tngtech.archunit.core.domain.JavaAccess;
import com.tngtech.archunit.lang.ArchRule;
import java.util.List;
import java.util.regex.Pattern;

/**
 * The rules that make the simulation give the same bits for the same level and input on every machine: it must not read
 * a clock, draw unseeded randomness, depend on hash order, or call a transcendental function that processors round
 * differently.
 */
final class DeterminismRules {
    private static final String[] SIMULATION = {
        "nephele.engine.math..", "nephele.engine.portal..", "nephele.engine.collision..", "nephele.engine.sim.."
    };

    private static final Pattern CLOCK = Pattern.compile("java\\.lang\\.System\\.(nanoTime|currentTimeMillis)"
            + "|java\\.time\\..*\\.now|java\\.util\\.Date\\.<init>");

    private static final Pattern RANDOMNESS = Pattern.compile("java\\.lang\\.(Strict)?Math\\.random"
            + "|java\\.util\\.(Random|SplittableRandom|UUID|concurrent\\.ThreadLocalRandom)\\..*"
            + "|java\\.lang\\.System\\.identityHashCode|java\\.lang\\.Object\\.hashCode");

    private static final Pattern TRANSCENDENTAL =
            Pattern.compile("java\\.lang\\.Math\\.(sin|cos|tan|asin|acos|atan|atan2"
                    + "|sinh|cosh|tanh|exp|expm1|log|log10|log1p|pow|cbrt|hypot)");

    /**
     * The names of JOML methods that reach sin, cos, tan, acos, asin or atan2; its own Math as a whole. Compared with
     * the call graph of JOML 1.10.9: of 705 such methods only those that take an AxisAngle4 have other names, and that
     * type is listed.
     */
    private static final Pattern JOML_TRIGONOMETRY = Pattern.compile("org\\.joml\\.Math\\..*"
            + "|org\\.joml\\.AxisAngle4.*"
            + "|org\\.joml\\.\\w+\\.(\\w*[rR]otat\\w*|\\w*[sS]lerp\\w*|\\w*[aA]ngle\\w*|\\w*Euler\\w*|integrate"
            + "|\\w*[pP]erspective\\w*|\\w*[fF]ov\\w*|arcball\\w*|lookAlong|\\w*[oO]blique\\w*|orthoCrop|difference"
            + "|nlerpIterative|trapezoidCrop|shadow|reflect\\w*|getScale\\w*|random\\w*)");

    /** Collections with an order that depends on addresses, or on a salt that differs in every process. */
    private static final Pattern HASH_ORDER = Pattern.compile(
            "java\\.util\\.(HashMap|HashSet|IdentityHashMap|WeakHashMap|Hashtable|concurrent\\.ConcurrentHashMap)\\.<init>"
                + "|java\\.util\\.(Map|Set)\\.(of|ofEntries|copyOf)"
                + "|java\\.util\\.stream\\.Collectors\\.(toSet|toMap|groupingBy|toUnmodifiableSet|toUnmodifiableMap)");

    static final List<ArchRule> ALL = List.of(
            simulationCallsNone("a clock", CLOCK),
            simulationCallsNone("unseeded or foreign randomness", RANDOMNESS),
            simulationCallsNone("a transcendental of Math: StrictMath has the same", TRANSCENDENTAL),
            simulationCallsNone(
                    "trigonometry of JOML: Rotations and Directions have it by StrictMath", JOML_TRIGONOMETRY),
            simulationCallsNone("a collection in hash order", HASH_ORDER));

    private DeterminismRules() {}

    private static ArchRule simulationCallsNone(String what, Pattern names) {
        return noClasses()
                .that()
                .resideInAnyPackage(SIMULATION)
                .should()
                .accessTargetWhere(describe(what, (JavaAccess<?> access) -> names.matcher(
                                access.getTargetOwner().getName() + "."
                                        + access.getTarget().getName())
                        .matches()))
                .as("the simulation calls no " + what);
    }
}
