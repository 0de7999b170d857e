package nephele.engine.level;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import nephele.engine.level.json.LevelJsonTest;
import nephele.engine.rule.LevelRules;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Levels at the limits of a file are accepted, and levels just beyond are refused. */
class LevelBoundsTest {
    private static final String SPOT = "{\"id\": \"s%d\", \"kind\": \"spot\", \"position\": [0, 9, 0], "
            + "\"direction\": [0, -1, 0], \"radiantIntensity\": [1, 1, 1]}";
    private static final String CAPSULE = "\"bodies\": [{\"id\": \"c\", \"kind\": \"capsule\", \"centre\": [0, 9, 0], "
            + "\"radiusMetres\": 0.25, \"heightMetres\": %s, \"massKilograms\": 1}]";

    private static String lights(int count) {
        return IntStream.range(0, count)
                .mapToObj(SPOT::formatted)
                .collect(Collectors.joining(",", "\"lights\": [", "]"));
    }

    private static String file(String members) {
        return "{\"format\": \"nephele-level\", \"version\": 1, " + members + "}";
    }

    private static List<String> errors(String members) {
        Level level = LevelJsonTest.sections(members);
        return LevelRules.checkRecords(level).stream()
                .filter(Problem::isError)
                .map(problem -> problem.line("x"))
                .toList();
    }

    @Test
    void aListMayBeAsLongAsTheSchemaSays() {
        assertEquals(1000, LevelJsonTest.sections(lights(1000)).lights().size());
        assertEquals(1, LevelJsonTest.problems(file(lights(1001))).size());
    }

    @ParameterizedTest
    @CsvSource({"innerConeDegrees, 0", "innerConeDegrees, 90", "outerConeDegrees, 0.1", "outerConeDegrees, 90"})
    void bothEndsOfARangeAreInIt(String key, double value) {
        String light = SPOT.formatted(0).replace("}", ", \"" + key + "\": %s}");
        LevelJsonTest.sections("\"lights\": [" + light.formatted(value) + "]");
        double beyond = value < 1 ? Math.nextDown(value) : Math.nextUp(value);
        String refused = file("\"lights\": [" + light.formatted(beyond) + "]");
        assertEquals(1, LevelJsonTest.problems(refused).size());
    }

    @Test
    void aCapsuleMayBeABall() {
        assertEquals(List.of(), errors(CAPSULE.formatted("0.5")));
        assertEquals(1, errors(CAPSULE.formatted("0.49999999")).size());
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "\"cameras\": [{\"id\": \"a\", \"position\": [0, 0, 0], \"target\": [0, 0, 1]}*]",
                "\"materials\": [{\"id\": \"a\"}*]",
                "\"solids\": [{\"id\": \"a\", \"kind\": \"box\", \"centre\": [0, -9, 0], \"size\": [1, 1, 1]}*]",
                "\"lights\": [{\"id\": \"a\", \"kind\": \"point\", \"position\": [0, 9, 0], \"radiantIntensity\": [1,"
                        + " 1, 1]}*]",
                "\"models\": [{\"id\": \"a\", \"file\": \"sphere_1_8_8.3d\"}*]",
                "\"bodies\": [{\"id\": \"a\", \"kind\": \"sphere\", \"centre\": [0, 9, 0], \"radiusMetres\": 1,"
                        + " \"massKilograms\": 1}*]"
            })
    void twoOfASectionMayNotShareAnId(String section) {
        String one = section.replace("*", "");
        String record = one.substring(one.indexOf('{'), one.lastIndexOf('}') + 1);
        String name = section.substring(1, section.indexOf('"', 1));
        List<String> twice = errors(section.replace("*", "," + record));
        long shared = twice.stream()
                .filter(line -> line.startsWith("x: " + name + "[1].id: 'a' is already the id of " + name + "[0]"))
                .count();
        assertEquals(1, shared, twice::toString);
    }

    /** The first fifty of sixty unknown keys are reported, and none is mistaken for a known one. */
    @Test
    void everyUnknownKeyIsToldHoweverManyThereAre() {
        String unknown =
                IntStream.range(0, 60).mapToObj(i -> "\"u" + i + "\": 0").collect(Collectors.joining(", "));
        String json = "{" + unknown + ", \"format\": \"nephele-level\", \"version\": 1, \"name\": \"n\"}";
        Set<String> told =
                LevelJsonTest.problems(json).stream().map(Problem::path).collect(Collectors.toSet());
        Set<String> expected =
                IntStream.range(0, 50).mapToObj(i -> "u" + i).collect(Collectors.toCollection(TreeSet::new));
        expected.add("$");
        assertEquals(expected, new TreeSet<>(told));
    }
}
