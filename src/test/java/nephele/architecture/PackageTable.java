package nephele.architecture;

import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.lang.ArchCondition;
import com.tngtech.archunit.lang.ConditionEvents;
import com.tngtech.archunit.lang.SimpleConditionEvent;
import com.tngtech.archunit.library.dependencies.SliceAssignment;
import com.tngtech.archunit.library.dependencies.SliceIdentifier;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;

/**
 * Which package uses which, and which module. Dependencies are transitive; a subpackage belongs to the row above it.
 */
final class PackageTable {
    private static final String ENGINE = "nephele.engine.";

    private static final List<String> HEADLESS = List.of(
            "math",
            "level",
            "asset",
            "model",
            "portal",
            "scene",
            "collision",
            "cloud",
            "particle",
            "lightning",
            "atmosphere");

    private static final Map<String, List<String>> USES = new LinkedHashMap<>();

    static {
        USES.put("math", List.of());
        USES.put("work", List.of());
        USES.put("atmosphere", List.of("math", "work"));
        USES.put("level", List.of("math", "asset", "model", "atmosphere"));
        USES.put("asset", List.of("math", "work"));
        USES.put("model", List.of("math", "asset"));
        USES.put("portal", List.of("level"));
        USES.put("scene", List.of("portal", "model", "asset"));
        USES.put("collision", List.of("portal", "model"));
        USES.put("sim", List.of("collision", "portal", "model"));
        USES.put("rule", List.of("sim"));
        USES.put("cloud", List.of("level", "asset"));
        USES.put("choice", List.of("sim", "render"));
        USES.put("particle", List.of("collision"));
        USES.put("lightning", List.of("level"));
        USES.put("reference", List.of("portal", "model", "cloud"));
        USES.put("bake", List.of("reference", "scene"));
        USES.put("measure", List.of());
        USES.put("render.gl", List.of("math", "work"));
        USES.put("render.line", with("render.gl", HEADLESS));
        USES.put("render.frame", with("render.gl", HEADLESS));
        USES.put("render.resource", List.of("render.frame"));
        USES.put("render.pass", List.of("render.resource"));
        USES.put("render", with("render.pass", HEADLESS));
        USES.put("host.terminal", List.of());
        USES.put("host.userfile", List.of("asset"));
        USES.put("host.named", List.of("host.terminal", "scene", "rule"));
        USES.put("host.playthrough", List.of("host.named"));
        USES.put("host.compare", List.of("choice", "measure"));
        USES.put("host.draw", List.of("choice", "host.named"));
        USES.put("scenes.xml", List.of("level", "model"));
        USES.put("scenes.fixed", with("scenes.xml", with("render.gl", HEADLESS)));
        USES.put("scenes.file", List.of("scenes.fixed", "host.terminal", "rule"));
        USES.put("scenes.view", List.of("scenes.file", "render"));
    }

    private PackageTable() {}

    private static List<String> with(String first, List<String> others) {
        return java.util.stream.Stream.concat(java.util.stream.Stream.of(first), others.stream())
                .toList();
    }

    /** Returns the longest row that contains the package; {@code null} if there is none. */
    static String row(String packageName) {
        String best = null;
        for (String row : USES.keySet()) {
            String prefix = row.startsWith("host.") || row.startsWith("scenes.") ? "nephele." : ENGINE;
            boolean holds = (packageName + ".").startsWith(prefix + row + ".");
            if (holds && (best == null || row.length() > best.length())) {
                best = row;
            }
        }
        return best;
    }

    /** Returns a row and everything that it may use. */
    static Set<String> closure(String row) {
        Set<String> reached = new TreeSet<>();
        reach(row, reached);
        return reached;
    }

    private static void reach(String row, Set<String> reached) {
        if (reached.add(row)) {
            USES.get(row).forEach(next -> reach(next, reached));
        }
    }

    /** The modules that each module uses. */
    static final Map<String, List<String>> MODULES = Map.of(
            "engine", List.of(),
            "host", List.of("engine"),
            "scenes", List.of("engine", "host"),
            "lab", List.of("engine", "host", "scenes"),
            "editor", List.of("engine", "host"),
            "app", List.of("engine", "host", "scenes", "lab", "editor"),
            "workshop", List.of("engine", "host", "scenes", "lab", "editor", "app"));

    static ArchCondition<JavaClass> useOnlyModulesOfTheTable() {
        return new ArchCondition<>("use only modules that the table allows") {
            @Override
            public void check(JavaClass origin, ConditionEvents events) {
                String own = module(origin);
                if (!MODULES.containsKey(own)) {
                    events.add(SimpleConditionEvent.violated(origin, origin.getName() + " is in no module"));
                    return;
                }
                origin.getDirectDependenciesFromSelf().forEach(dependency -> {
                    String other = module(dependency.getTargetClass().getBaseComponentType());
                    if (other != null && !other.equals(own) && !MODULES.get(own).contains(other)) {
                        events.add(SimpleConditionEvent.violated(origin, dependency.getDescription()));
                    }
                });
            }
        };
    }

    /** Returns the module of a class of ours, named like its package; {@code null} of any other class. */
    private static String module(JavaClass type) {
        String[] words = type.getPackageName().split("\\.");
        return words.length > 1 && words[0].equals("nephele") ? words[1] : null;
    }

    /** Returns one slice for each package, so that a package and its subpackages can form a cycle, too. */
    static SliceAssignment slices() {
        return new SliceAssignment() {
            @Override
            public SliceIdentifier getIdentifierOf(JavaClass type) {
                String name = type.getPackageName();
                return name.startsWith("nephele.") ? SliceIdentifier.of(name) : SliceIdentifier.ignore();
            }

            @Override
            public String getDescription() {
                return "packages";
            }
        };
    }

    static ArchCondition<JavaClass> useOnlyWhatTheTableAllows() {
        return new ArchCondition<>("use only what PackageTable allows") {
            @Override
            public void check(JavaClass origin, ConditionEvents events) {
                String row = row(origin.getPackageName());
                if (row == null) {
                    events.add(SimpleConditionEvent.violated(origin, origin.getName() + " is in no row of the table"));
                    return;
                }
                Set<String> allowed = closure(row);
                origin.getDirectDependenciesFromSelf().forEach(dependency -> {
                    String target =
                            dependency.getTargetClass().getBaseComponentType().getPackageName();
                    boolean ours = target.startsWith("nephele.");
                    String targetRow = row(target);
                    if (ours && (targetRow == null || !allowed.contains(targetRow))) {
                        events.add(SimpleConditionEvent.violated(origin, dependency.getDescription()));
                    }
                });
            }
        };
    }

    /**
     * Forbids dependencies between {@code render.pass.x} and {@code render.pass.y}; the shared {@code
     * render.pass.cloud} is excepted.
     */
    static ArchCondition<JavaClass> useNoOtherPass() {
        return new ArchCondition<>("use no other pass") {
            @Override
            public void check(JavaClass origin, ConditionEvents events) {
                String own = pass(origin.getPackageName());
                origin.getDirectDependenciesFromSelf().forEach(dependency -> {
                    String targetPackage =
                            dependency.getTargetClass().getBaseComponentType().getPackageName();
                    String other = pass(targetPackage);
                    boolean shared = targetPackage.equals(ENGINE + "render.pass.cloud");
                    if (other != null && !shared && !other.equals(own)) {
                        events.add(SimpleConditionEvent.violated(origin, dependency.getDescription()));
                    }
                });
            }
        };
    }

    private static String pass(String packageName) {
        String prefix = ENGINE + "render.pass.";
        return packageName.startsWith(prefix) ? packageName.substring(prefix.length()) : null;
    }
}
