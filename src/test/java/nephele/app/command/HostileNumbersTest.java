package nephele.app.command;

import static org.junit.jupiter.api.Assertions.assertAll;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Stream;
import nephele.engine.level.Range;
import nephele.workshop.Workshop;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import picocli.CommandLine;
import picocli.CommandLine.Model.OptionSpec;

/** A number that an option does not take is wrong usage, whatever it is: the message names the option and its range. */
class HostileNumbersTest {
    private static final Set<Class<?>> NUMBERS = Set.of(
            int.class, Integer.class, long.class, Long.class, float.class, Float.class, double.class, Double.class);

    private static final List<String> NEVER = List.of("NaN", "-Infinity", "1e300", "x", "", "0x10", "1,5", "1d");

    private static final Map<String, String> REST = Map.of(
            "render", "levels/01-courtyard.json --reference --out OUT.pfm --eye 0,2,0 --target 1,2,0",
            "simulate", "levels/01-courtyard.json --dump OUT.json",
            "bench", "levels/01-courtyard.json",
            "bake", "levels/01-courtyard.json --sky OUT",
            "prove", "formats --count 1",
            "play", "levels/01-courtyard.json --replay OUT.replay",
            "trade", "--list",
            "scene", "scenes/none.xml --out OUT.png",
            "edit", "levels/01-courtyard.json --script OUT.script");

    @TempDir
    Path folder;

    private Captured run(String command, String option, String value) {
        List<String> words = new ArrayList<>(List.of(command));
        Arrays.stream(REST.get(command).split(" "))
                .map(word -> word.replace("OUT", folder.resolve("out").toString()))
                .forEach(words::add);
        if (words.contains(option)) {
            int at = words.indexOf(option);
            words.subList(at, at + 2).clear();
        }
        words.add(option + "=" + value);
        return Captured.run(words.toArray(String[]::new));
    }

    private Captured assertRefused(String command, String option, String value) {
        var answer = run(command, option, value);
        assertAll(
                command + " " + option + "=" + value + ": " + answer.err(),
                () -> assertEquals(2, answer.exitCode()),
                () -> assertTrue(answer.err().startsWith("nephele " + command + ": ")),
                () -> assertTrue(answer.err().contains(option)),
                () -> assertFalse(answer.err().contains("Exception")),
                () -> assertEquals("", answer.out()),
                () -> assertEquals(0, folder.toFile().list().length));
        return answer;
    }

    private record NumericOption(String command, OptionSpec option) {
        static Stream<NumericOption> all() {
            return Workshop.COMMANDS.stream()
                    .flatMap(entry -> new CommandLine(entry.build().get())
                            .getCommandSpec().options().stream()
                                    .filter(option -> NUMBERS.contains(option.type()))
                                    .map(option -> new NumericOption(entry.name(), option)));
        }

        /** Returns the numbers just outside the range, as the sentence about it says. */
        Stream<String> justOutside() {
            String[] words = OptionRange.of(option).orElseThrow().allowed().split(" from | to ");
            boolean isWhole = words[0].contains("whole");
            return Stream.of(
                    isWhole ? plus(words[1], -1) : Double.toString(Math.nextDown(Double.parseDouble(words[1]))),
                    isWhole ? plus(words[2], 1) : Double.toString(Math.nextUp(Double.parseDouble(words[2]))));
        }

        private static String plus(String number, int change) {
            return new java.math.BigInteger(number)
                    .add(java.math.BigInteger.valueOf(change))
                    .toString();
        }

        @Override
        public String toString() {
            return command + " " + option.longestName();
        }
    }

    static Stream<NumericOption> numericOptions() {
        return NumericOption.all();
    }

    @ParameterizedTest
    @MethodSource("numericOptions")
    void everyNumericOptionHasARangeAndKeepsIt(NumericOption tried) {
        OptionRange range = OptionRange.of(tried.option).orElseThrow(() -> new AssertionError(tried + " has no range"));
        Stream.concat(NEVER.stream(), tried.justOutside()).forEach(value -> {
            assertFalse(range.contains().test(value), value);
            var answer = assertRefused(tried.command, tried.option.longestName(), value);
            assertTrue(answer.err().contains(range.allowed()), answer.err());
        });
    }

    static Stream<Arguments> wordsOfNumbers() {
        return Stream.concat(
                Stream.of(
                                "render|--size|0x0 16385x1 1x16385 99999999999x1 -1x5 NaNxNaN 8 1e3x1e3",
                                "bench|--size|0x0",
                                "trade|--size|0x0",
                                "scene|--size|0x0",
                                "play|--size|0x0",
                                "render|--eye|nan,1,1 1e300,0,0 10000001,0,0 1,2 1,2,3,4 , 1;2;3",
                                "render|--target|0,-Infinity,0 0,0,-1e8",
                                "bake|--eye|0,0,inf 1e9,0,0",
                                "play|--from|nan,0,0,0,0 0,0,0,1e300,0 0,0,0,0,90.5 0,0,0,0,-91 1e8,0,0,0,0 1,2,3",
                                "render|--shard|3/2 0/1 1/0 1/100001 -1/2 NaN/2 1/99999999999",
                                "prove|--shard|3/2 0/1 1/0 1/100001 NaN/2",
                                "play|--upright-rate|0 9 180001 -1 NaN 1e3 99999999999")
                        .map(line -> Arguments.of((Object[]) line.split("\\|"))),
                settings().map(name -> Arguments.of("render", "--set", name + "=NaN " + name + "=1e300")));
    }

    /** Returns the names that {@code --set} knows. */
    private static Stream<String> settings() {
        String err = Captured.run("render", "levels/01-courtyard.json", "--out", "x.png", "--set", "none=1")
                .err();
        String names = err.substring(err.indexOf("it knows: ") + 10, err.indexOf('\n'));
        return Arrays.stream(names.split(", "));
    }

    @ParameterizedTest
    @MethodSource("wordsOfNumbers")
    void wordsMadeOfNumbersAreRefusedTheSameWay(String command, String option, String values) {
        Arrays.stream(values.split(" ")).forEach(value -> assertRefused(command, option, value));
    }

    @ParameterizedTest
    @CsvSource({
        "plane 2 3, 2",
        "box 2 3, 2",
        "cone 1 2 4 3, 4",
        "sphere 1 8 8, 3",
        "cylinder 1 2 8, 3",
        "torus 1 0.3 8 6, 4",
        "patch assets/models/teapot.patch 2, 1",
        "tree oak 1, 1",
        "rock boulder 1, 1",
        "terrain 1 64, 2"
    })
    void generateNamesTheNumberThatItDoesNotTake(String line, int numbers) {
        String[] words = line.split(" ");
        for (int at = words.length - numbers; at < words.length; at++) {
            for (String value : List.of("NaN", "1e300", "x", "", "5e-324", "9223372036854775808")) {
                List<String> hostile = new ArrayList<>(List.of("generate"));
                hostile.addAll(Arrays.asList(words));
                hostile.set(at + 1, value);
                hostile.add(folder.resolve(line.startsWith("terrain") ? "out.png" : "out.3d")
                        .toString());
                var answer = Captured.run(hostile.toArray(String[]::new));
                assertEquals(2, answer.exitCode(), hostile + ": " + answer.err());
                assertTrue(answer.err().matches("(?s)nephele generate: .*[A-Z]{4,} is .*"), answer.err());
            }
        }
        assertFalse(Files.exists(folder.resolve("out.3d")));
    }

    /** A place on the command line may be wherever a level's may. */
    @Test
    void placesHaveTheRangeOfALevelsCoordinates() throws NoSuchMethodException {
        assertEquals(Range.class.getMethod("max").getDefaultValue(), OptionValues.MOST);
        assertEquals(Range.class.getMethod("min").getDefaultValue(), -OptionValues.MOST);
    }
}
