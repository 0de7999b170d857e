package nephele.engine.render.gl.shader;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.lang.reflect.Array;
import java.lang.reflect.Field;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import nephele.engine.math.Vec3;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestInstance;
import org.junit.jupiter.api.TestInstance.Lifecycle;

/**
 * A constant that GLSL and Java share stands once, in Java: shaders take its value by {@code java(package.Class.NAME)}.
 * Every other constant of a shader is in the list of those that only shaders have, and no Java class has one of its name
 * and value.
 */
@TestInstance(Lifecycle.PER_CLASS)
class ShaderConstantsTest {
    private static final List<Path> SHADERS = List.of(
            Path.of("engine/src/main/resources/nephele/engine/render"),
            Path.of("scenes/src/main/resources/nephele/scenes"));
    private static final List<Path> SOURCES =
            List.of(Path.of("engine/src/main/java"), Path.of("scenes/src/main/java"), Path.of("src/test/java"));

    private static final Pattern CONSTANT =
            Pattern.compile("(?m)^[ \\t]*const \\w+ ([A-Z][A-Z_0-9]*)(?:\\[\\w*\\])? = ([^;]*);[^\\n]*$");
    private static final Pattern DEFINED = Pattern.compile("(?m)^[ \\t]*#define ([A-Z]\\w*) +[-\\d.]");
    private static final String OF_JAVA = "java(";
    private static final Pattern NUMBER = Pattern.compile("(?<![\\w.])-?\\d+(?:\\.\\d*)?(?:e-?\\d+)?(?![\\w.])");

    /** Constants of mathematics, in single precision, and the corners of a square. */
    private static final Map<String, List<Double>> MATHEMATICS = Map.of(
            "PI", List.of(Math.PI),
            "TURN", List.of(2 * Math.PI),
            "FOUR_PI", List.of(4 * Math.PI),
            "PER_DISC", List.of(3 / Math.PI),
            "ROOT_2", List.of(Math.sqrt(2)),
            "ROOT_HALF_PI", List.of(Math.sqrt(Math.PI / 2)),
            "PER_LOG2", List.of(Math.log(2) / Math.log(3)),
            "MESH_HALF", List.of(Math.sqrt(80)),
            "UP", List.of(0.0, 1.0, 0.0),
            "CORNERS", List.of(-1.0, -1.0, 1.0, -1.0, 1.0, 1.0, -1.0, 1.0));

    /** What only shaders have. */
    private static final Set<String> OF_SHADERS = Set.of(("muzzle.frag/GUN_DEPTH muzzle.frag/FAR"
        + " billboard.vert/FADE_SHARE edges.frag/LEAST_DIFFERENCE smooth.frag/FARTHEST shadow-filter.glsl/FARTHEST"
        + " atmosphere.frag/SEA_COUNT atmosphere.frag/RAYED_COUNT plant.frag/LIFT impostor.frag/LIFT"
        + " ring.frag/STRIP_START ring.frag/STRIP_WIDTH ring.frag/CHEVRONS_PER_SECOND glow.frag/START glow.frag/WIDTH"
        + " bolt.vert/NEAREST bolt.vert/WIDTH bolt.vert/THINNEST bolt.vert/MAIN billboard.vert/LIT_ASIDE"
        + " skybox.frag/ENDLESS_KILOMETRES impostor.frag/FAINTEST particle.frag/SAMPLES spread.frag/STILL"
        + " spread.frag/TRUSTED spread.frag/UNKNOWN shaft.frag/STEPS particle.vert/NEAREST cells.frag/LEAST_SHARE"
        + " axes-cross.vert/FROM_CORNER air.glsl/AIR_MORE_THAN_RED air.glsl/AIR_BLOCKS air.glsl/SHAFT_DISTANCES"
        + " finite.glsl/EXPONENT cloud-flash.glsl/FLASH_SOFTENING cloud-flash.glsl/FLASH_SURFACE"
        + " puff-light.glsl/SIGHT_STEPS quad.glsl/LEAST_AHEAD cloud-pixel.glsl/THINNEST puff.glsl/MOST_DEVIATIONS"
        + " held-look.glsl/EDGE_OPACITY held-look.glsl/LINE_SHARE held-look.glsl/FADE_SHARE"
        + " fixed-light.glsl/LIGHT_TEXELS plant-light.glsl/ALL_DIRECTIONS impostor-texels.glsl/VIEW_EDGE"
        + " impostor-texels.glsl/STEPS cloud-sheet.glsl/SHEET_STEPS cloud-sheet.glsl/FARTHEST_SHEET"
        + " cloud-sheet.glsl/MESH_DIVISIONS cloud-sheet.glsl/MESH_CURVE cloud-span.glsl/NEVER"
        + " puff-beam.glsl/BEAM_STEPS exit-curtain.glsl/VEIL exit-curtain.glsl/VEIL_COLOUR gun.vert/DEPTH_SHARE"
        + " gun.vert/FILL gun.vert/LIGHT_SHARE gun.vert/OUTLINE cuts.frag/THIN cuts.frag/STEEP cuts.frag/WITHIN_BLOCK"
        + " cuts.frag/ASYMMETRY over.frag/NEAR over.frag/FAINT output.glsl/SKY_ALPHA output.glsl/SURFACE_ALPHA"
        + " temporal.frag/CODE_VALUE temporal.frag/FIRST_TRUSTED temporal.frag/LEFT_OF_MOTION"
        + " temporal.frag/MOST_AT_REST temporal.frag/MOST_SPREAD temporal.frag/REJECTED temporal.frag/SETTLED"
        + " temporal.frag/SLACK")
            .split(" "));

    /** Java constants that are something else than the shader's constant of their name and value. */
    private static final Set<String> OTHERS =
            Set.of("DetailRanges.NEVER", "ViewRaster.SAMPLES", "TracedExposure.SAMPLES");

    /** @param values the numbers of its text, one after another */
    private record Constant(String file, String name, String text, List<Double> values) {
        String place() {
            return file + "/" + name;
        }
    }

    private final List<Constant> constants = new ArrayList<>();
    private final Map<String, String> classes = new HashMap<>();

    @BeforeAll
    void read() throws IOException {
        for (Path folder : SHADERS) {
            readShaders(folder);
        }
        for (Path folder : SOURCES) {
            readClasses(folder);
        }
    }

    private static List<Path> files(Path folder) {
        try (Stream<Path> files = Files.walk(folder)) {
            return files.filter(Files::isRegularFile).sorted().toList();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private void readShaders(Path folder) {
        for (Path file : files(folder)) {
            String text = resource(file.toString().replace('\\', '/').replaceFirst(".*/resources/", "/"));
            assertFalse(DEFINED.matcher(text).find(), file + " defines a number; write it as a const");
            Matcher found = CONSTANT.matcher(text);
            Map<String, Constant> before = new HashMap<>();
            while (found.find()) {
                String value = found.group();
                Constant constant = new Constant(
                        file.getFileName().toString(), found.group(1), value, values(found.group(2), before));
                before.put(constant.name, constant);
                constants.add(constant);
            }
        }
    }

    private void readClasses(Path folder) throws IOException {
        try (Stream<Path> files = Files.walk(folder)) {
            files.filter(file -> file.toString().endsWith(".java")).forEach(file -> {
                String path = folder.relativize(file).toString().replaceAll("[/\\\\]", ".");
                classes.put(file.getFileName().toString().replace(".java", ""), path.replaceAll("\\.java$", ""));
            });
        }
    }

    /** Returns a shader as programs find it: on the class path, which may have another one first. */
    private static String resource(String path) {
        try (InputStream in = ShaderSource.class.getResourceAsStream(path)) {
            return new String(in.readAllBytes(), StandardCharsets.UTF_8);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** Returns the numbers of a list, or the product or quotient of those of a formula. */
    private static List<Double> values(String text, Map<String, Constant> before) {
        String formula = text.replaceAll("//[^\\n]*", "");
        String[] factors = formula.split(" (?=[*/] )");
        List<Double> values = new ArrayList<>(numbers(factors[0], before));
        for (int i = 1; i < factors.length; i++) {
            double factor = numbers(factors[i].substring(2), before).get(0);
            boolean divides = factors[i].charAt(0) == '/';
            values.replaceAll(value -> divides ? value / factor : value * factor);
        }
        return values;
    }

    private static List<Double> numbers(String text, Map<String, Constant> before) {
        Constant known = before.get(text.strip());
        return known != null
                ? known.values
                : NUMBER.matcher(text)
                        .results()
                        .map(number -> Double.parseDouble(number.group()))
                        .toList();
    }

    private List<Double> ofJava(String twin) {
        String[] words = twin.split("\\.");
        String name = classes.get(words[0]);
        for (int i = 1; i < words.length - 1; i++) {
            name += "$" + words[i];
        }
        try {
            Field field = Class.forName(name).getDeclaredField(words[words.length - 1]);
            field.setAccessible(true);
            return numbers(field.get(null));
        } catch (ReflectiveOperationException | NullPointerException missing) {
            throw new AssertionError("there is no constant " + twin, missing);
        }
    }

    private static List<Double> numbers(Object value) {
        if (value instanceof Number number) {
            return List.of(number.doubleValue());
        }
        if (value instanceof Vec3 v) {
            return List.of(v.x(), v.y(), v.z());
        }
        if (value instanceof Enum<?> word) {
            return List.of((double) word.ordinal());
        }
        List<Double> all = new ArrayList<>();
        for (int i = 0; value.getClass().isArray() && i < Array.getLength(value); i++) {
            all.addAll(numbers(Array.get(value, i)));
        }
        return all;
    }

    private static void assertSame(List<Double> expected, List<Double> found, String place) {
        assertEquals(expected.size(), found.size(), place);
        for (int i = 0; i < expected.size(); i++) {
            assertEquals(expected.get(i), found.get(i), 1e-7 * Math.abs(expected.get(i)), place);
        }
    }

    /** Assembling fails if Java has no such constant. */
    @Test
    void everyConstantThatShadersTakeFromJavaExists() {
        int taken = 0;
        for (Path folder : SHADERS) {
            for (Path file : files(folder)) {
                String path = file.toString().replace('\\', '/').replaceFirst(".*/resources/", "/");
                String text = new AssembledShader(ShaderSource.load(path, Map.of())).text();
                assertFalse(text.contains(OF_JAVA), path);
                taken += resource(path).contains(OF_JAVA) ? 1 : 0;
            }
        }
        assertTrue(taken > 20, taken + " files take constants");
    }

    @Test
    void aConstantIsTakenFromJavaOrOnlyShadersHaveIt() {
        Set<String> alone = new TreeSet<>();
        for (Constant constant : constants) {
            if (MATHEMATICS.containsKey(constant.name)) {
                assertSame(MATHEMATICS.get(constant.name), constant.values, constant.place());
            } else if (!constant.text.contains(OF_JAVA)) {
                alone.add(constant.place());
            }
        }
        Set<String> gone = new TreeSet<>(OF_SHADERS);
        gone.removeAll(alone);
        alone.removeAll(OF_SHADERS);
        assertEquals(Set.of(), alone, "take them from Java, or add them to the list");
        assertEquals(Set.of(), gone, "are in no shader any more, or are taken from Java");
    }

    @Test
    void noJavaClassHasAConstantThatOnlyShadersHave() throws ClassNotFoundException {
        Map<String, List<Constant>> alone = constants.stream()
                .filter(constant -> OF_SHADERS.contains(constant.place()))
                .collect(Collectors.groupingBy(Constant::name));
        Set<String> found = new TreeSet<>();
        for (String name : classes.values()) {
            if (name.endsWith("-info")) {
                continue;
            }
            Class<?> type = Class.forName(name, false, getClass().getClassLoader());
            for (Field field : type.getDeclaredFields()) {
                String twin = type.getSimpleName() + "." + field.getName();
                if (alone.containsKey(field.getName())
                        && java.lang.reflect.Modifier.isStatic(field.getModifiers())
                        && !OTHERS.contains(twin)
                        && alone.get(field.getName()).stream()
                                .anyMatch(constant -> constant.values.equals(ofJava(twin)))) {
                    found.add(twin);
                }
            }
        }
        assertEquals(Set.of(), found);
    }
}
