package nephele.engine.rule;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.IntStream;
import nephele.engine.asset.LevelAssets;
import nephele.engine.level.Level;
import nephele.engine.level.json.LevelJsonTest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class CloudRulesTest {
    private static List<String> lines(String environment) {
        Level level = LevelJsonTest.sections("\"environment\": {" + environment + "}");
        return LevelRules.checkRecordsAndFiles(level, LevelAssets.beside(Path.of("x.json"))).stream()
                .filter(problem -> problem.path().startsWith("environment"))
                .map(problem -> problem.line("f").replace("f: environment.", ""))
                .toList();
    }

    private static String clouds(String... clouds) {
        return "\"clouds\": [" + String.join(", ", clouds) + "]";
    }

    private static String layer(String id, String rest) {
        return "{\"id\": \"" + id + "\", \"kind\": \"layer\", \"baseAltitudeMetres\": 900, \"thicknessMetres\": 300"
                + rest.replace("'", "\"") + "}";
    }

    private static String puffs(String rest) {
        return layer("c", ", 'density': {'kind': 'puffs'" + rest + "}");
    }

    private static String noise(String rest) {
        return layer("c", ", 'density': {'kind': 'noise'" + rest);
    }

    @Test
    void whatIsMeantIsGood() {
        assertEquals(List.of(), lines(clouds(layer("c", ""))));
        assertEquals(List.of(), lines(clouds(puffs(", 'puffs': [{'centre': [0, 0, 0], 'radiusMetres': 9}]"))));
        assertEquals(
                List.of(),
                lines(clouds(puffs(", 'fill': {'boxes': [{'centre': [0, 0, 0], 'size': [9, 9, 9]}], 'count': 9}"))));
        assertEquals(
                List.of(),
                lines(clouds(noise(", 'profile': 'cumulonimbus', 'anvil': 1}, 'evolutionSeconds': 1,"
                        + " 'windMetresPerSecond': [5, 0, -5]"))));
        assertEquals(List.of(), lines("\"weather\": \"storm\", \"weatherSeed\": 7, " + clouds(layer("c", ""))));
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            quoteCharacter = '~',
            value = {
                "| warning: shows nothing | .density",
                ", 'fill': {'boxes': []} | has no box | .density.fill.boxes",
                ", 'fill': {'boxes': [{'centre': [0, 0, 0], 'size': [9, 9, 9]}], 'count': 0} | warning: makes no puff |"
                        + " .density.fill.count",
                ", 'fill': {'boxes': [{'centre': [0, 0, 0], 'size': [9, 9, 9]}], 'count': 99999} | warning: so many |"
                        + " .density.fill.count"
            })
    void puffsThatShowNothingOrTooMuchAreTold(String rest, String words, String path) {
        require(clouds(puffs(rest == null ? "" : rest)), "clouds[0]" + path, words);
    }

    @Test
    void keysWithoutEffectAreTold() {
        require(clouds(noise(", 'anvil': 1, 'profile': 'cumulus'}")), "clouds[0].density.anvil", "warning: only");
        require(clouds(noise(", 'anvil': 1}")), "clouds[0].density.anvil", "warning: only the profile cumulonimbus");
        require(clouds(layer("c", ", 'evolutionSeconds': 9")), "clouds[0].evolutionSeconds", "warning: only noise");
        require(
                clouds(layer("c", ", 'windMetresPerSecond': [1, 2, 3]")),
                "clouds[0].windMetresPerSecond[1]",
                "keeps its altitude");
        require(clouds(layer("c", ", 'swayMetres': [1, 2, 3]")), "clouds[0].swayMetres[1]", "keeps its altitude");
        require("\"weatherSeed\": 3", "weatherSeed", "warning: has no effect without weather");
    }

    @Test
    void keyframesOfTheWeatherAreInOrderAndStandAlone() {
        String frames = "\"weatherKeyframes\": [{\"timeSeconds\": 0, \"weather\": \"few\"},"
                + " {\"timeSeconds\": 600, \"weather\": \"storm\"}]";
        assertEquals(List.of(), lines(frames));
        require(frames.replace("600", "0"), "weatherKeyframes[1].timeSeconds", "must be later");
        require("\"weather\": \"few\", " + frames, "weather", "leave this out");
        require(
                frames + ", " + clouds(layer("weather-scud", "")),
                "clouds[0].id",
                "is the id of a cloud of the weather");
    }

    @Test
    void aBackLobeWithoutShareIsTold() {
        require(clouds(layer("c", ", 'phaseBackG': -0.3")), "clouds[0].phaseBackG", "warning: has no effect");
        assertEquals(List.of(), lines(clouds(layer("c", ", 'phaseBackG': -0.3, 'phaseBackShare': 0.2"))));
    }

    @Test
    void aLayerUnderTheGroundOfARoundPlanetIsTold() {
        String low = layer("c", "").replace("900", "-900");
        assertEquals(List.of(), lines(clouds(low)));
        require(
                "\"sky\": {\"kind\": \"atmosphere\"}, " + clouds(low),
                "clouds[0].baseAltitudeMetres",
                "below the planet");
    }

    @Test
    void aMissingCoverageMapIsAnError() {
        require(clouds(noise(", 'coverageMap': 'no.png'}")), "clouds[0].density.coverageMap", "no such file");
    }

    @Test
    void aDamagedGridIsAnError(@TempDir Path folder) throws IOException {
        Files.writeString(folder.resolve("cut.vol"), "VOL");
        Level level = LevelJsonTest.sections(
                "\"environment\": {" + clouds(layer("c", ", 'density': {'kind': 'grid', 'file': 'cut.vol'}")) + "}");
        assertEquals(
                List.of("f: environment.clouds[0].density.file: cut.vol: is no Mitsuba .vol file; write one of version"
                        + " 3"),
                LevelRules.checkRecordsAndFiles(level, LevelAssets.beside(folder.resolve("x.json"))).stream()
                        .filter(problem -> problem.path().startsWith("environment"))
                        .map(problem -> problem.line("f"))
                        .toList());
    }

    @Test
    void aGridThatALayerCannotRepeatIsAnError(@TempDir Path folder) throws IOException {
        ByteBuffer file = ByteBuffer.allocate(52).order(ByteOrder.LITTLE_ENDIAN);
        file.put(new byte[] {'V', 'O', 'L', 3})
                .putInt(1)
                .putInt(1)
                .putInt(1)
                .putInt(1)
                .putInt(1);
        file.putFloat(0)
                .putFloat(0)
                .putFloat(0)
                .putFloat(0)
                .putFloat(5)
                .putFloat(6)
                .putFloat(1);
        Files.write(folder.resolve("flat.vol"), file.array());
        String density = ", 'density': {'kind': 'grid', 'file': 'flat.vol'}".replace("'", "\"");
        String volume =
                "{\"id\": \"v\", \"kind\": \"volume\", \"centre\": [0, 0, 0], \"size\": [9, 9, 9]" + density + "}";
        Level level = LevelJsonTest.sections("\"environment\": {" + clouds(volume, layer("c", density)) + "}");
        assertEquals(
                List.of("f: environment.clouds[1].density.file: flat.vol: has a bounding box of no width or depth, at"
                        + " which a layer repeats it; write the box in metres into its header, or make the cloud a"
                        + " volume"),
                LevelRules.checkRecordsAndFiles(level, LevelAssets.beside(folder.resolve("x.json"))).stream()
                        .filter(problem -> problem.path().startsWith("environment"))
                        .map(problem -> problem.line("f"))
                        .toList());
    }

    @Test
    void anIdOfTheWeatherIsTaken() {
        String written = clouds(layer("weather-scud", ""), layer("b", ""));
        require("\"weather\": \"overcast\", " + written, "clouds[0].id", "is the id of a cloud of the weather");
        assertEquals(List.of(), lines("\"weather\": \"few\", " + written));
    }

    private static void require(String environment, String path, String words) {
        List<String> lines = lines(environment);
        assertEquals(1, lines.size(), lines.toString());
        String line = lines.get(0);
        assertEquals(path, line.substring(0, line.indexOf(": ")), line);
        assertEquals(true, line.contains(words), line);
    }

    @Test
    void shaftsNeedAir() {
        String deck = clouds(layer("c", ", 'shafts': true"));
        require(
                deck,
                "clouds[0].shafts",
                "warning: only air shows shadows: choose the environment.sky kind atmosphere");
        assertEquals(List.of(), lines("\"sky\": {\"kind\": \"atmosphere\"}, " + deck));
        assertEquals(List.of(), lines(clouds(layer("c", ", 'shafts': false"))));
    }

    /** What is too dear is said before anybody waits for it; what is not, is not. */
    @Test
    void cloudsThatTakeLongAreAWarningWithAnEstimate() {
        assertEquals(List.of(), lines(clouds(small(101))));
        assertEquals(
                List.of("clouds: warning: 400 clouds need some 591 s of a processor's time and 972 MB of memory before"
                        + " the first picture: use fewer of them, fewer layers, or the same seed of noise for several"),
                lines(clouds(IntStream.range(0, 400)
                        .mapToObj(i -> layer("c" + i, ", 'density': {'kind': 'noise', 'seed': " + i + "}"))
                        .toArray(String[]::new))));
    }

    private static String[] small(int count) {
        return IntStream.range(0, count)
                .mapToObj(i -> "{\"id\": \"c" + i + "\", \"kind\": \"volume\", \"centre\": [" + 4 * i
                        + ", 5, 0], \"size\": [3, 3, 3]}")
                .toArray(String[]::new);
    }
}
