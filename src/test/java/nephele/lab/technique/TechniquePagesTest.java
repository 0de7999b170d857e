package nephele.lab.technique;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import javax.xml.parsers.DocumentBuilderFactory;
import nephele.engine.choice.ErrorTable;
import nephele.engine.choice.ErrorTable.Row;
import nephele.engine.level.CloudTechnique;
import nephele.engine.level.Environment;
import nephele.engine.level.Level;
import nephele.engine.level.appearance.WeatherClouds;
import nephele.engine.level.json.LevelFile;
import org.junit.jupiter.api.Test;
import org.w3c.dom.Document;

/** The table and the pages about techniques are complete, true to the code and well-formed. */
class TechniquePagesTest {
    private static final String CODE = "nephele/engine/render/pass/cloud/";

    /** Returns the techniques that the engine has a folder of. */
    static List<CloudTechnique> built() {
        return TechniqueText.ALL.stream()
                .filter(technique -> Files.isDirectory(Path.of("engine/src/main/java", folder(technique))))
                .toList();
    }

    private static String folder(CloudTechnique technique) {
        return CODE + (technique == CloudTechnique.PARTICLES ? "particle" : TechniqueText.word(technique));
    }

    private static Document parsed(String html) {
        String xml = html.replace("<!DOCTYPE html>", "")
                .replace("&nbsp;", "&#160;")
                .replaceAll("<(meta|img|br)([^>]*)>", "<$1$2/>");
        try {
            return DocumentBuilderFactory.newInstance()
                    .newDocumentBuilder()
                    .parse(new ByteArrayInputStream(xml.getBytes(StandardCharsets.UTF_8)));
        } catch (Exception malformed) {
            throw new AssertionError(xml, malformed);
        }
    }

    private static Row row(CloudTechnique technique, double depth, double angle, double error) {
        return new Row("volume puffs", technique, depth, angle, 45, error, 10 * error);
    }

    @Test
    void theTableHasARowForEachTechniqueAndMediansOfItsErrors() {
        var table = new ErrorTable(List.of(
                row(CloudTechnique.VOLUME, 0.3, 5, 2),
                row(CloudTechnique.VOLUME, 0.3, 5, 4),
                row(CloudTechnique.VOLUME, 40, 30, 7)));
        Document page = parsed(CloudPages.opening(table));
        var rows = page.getElementsByTagName("tr");
        assertEquals(2 + TechniqueText.ALL.size(), rows.getLength());
        String volume = rows.item(rows.getLength() - 1).getTextContent();
        assertTrue(volume.startsWith("volume●●●●") && volume.contains("3––7" + "3070"), volume);
        for (CloudTechnique technique : CloudTechnique.values()) {
            assertEquals(technique != CloudTechnique.AUTO, TechniqueText.ALL.contains(technique), technique.name());
        }
        assertFalse(page.getDocumentElement().getTextContent().contains("not measured yet"));
        assertTrue(CloudPages.opening(new ErrorTable(List.of())).contains("not measured yet"));
    }

    @Test
    void eachTechniqueHasAWellFormedPageOfTenLinesAtMost() throws IOException {
        for (CloudTechnique technique : TechniqueText.ALL) {
            TechniqueText text = TechniqueText.of(technique);
            String html = new HandoutPage(text, command -> Optional.of("data:,")).html();
            Document page = parsed(html);
            int lines = text.all("how").size();
            assertTrue(lines >= 6 && lines <= 10, technique + ": " + lines + " lines");
            text.all("how").forEach(line -> assertTrue(line.length() < 180, line));
            assertTrue(
                    TechniqueText.PURPOSES.containsAll(
                            List.of(text.one("suited").split(", "))),
                    technique.name());
            assertEquals(
                    1 + 2 * text.failures().size(),
                    page.getElementsByTagName("img").getLength());
            assertEquals(text.all("failure").size(), text.all("wrong").size());
            assertEquals(text.all("failure").size(), text.all("right").size());
            assertFalse(html.matches("(?s).*(src|href)=\"(?!data:|#|technique-|index).*"), "refers to another file");
            assertFalse(html.contains("http"), "refers to the network");
        }
    }

    /** Each named function is in the shader, with the line that begins it and no other function. */
    @Test
    void shadersAreFound() {
        for (CloudTechnique technique : built()) {
            for (String place : TechniqueText.of(technique).all("shader")) {
                String[] parts = place.split(" ");
                ShaderExcerpt excerpt =
                        ShaderExcerpt.of(parts[0], parts[1]).orElseThrow(() -> new AssertionError("no " + place));
                List<String> lines = excerpt.lines().subList(excerpt.first(), excerpt.end());
                assertEquals(1, lines.stream().filter("}"::equals).count(), place);
                assertTrue(lines.stream().anyMatch(line -> line.contains(" " + parts[1] + "(")), place);
            }
        }
    }

    /** Lines that are not blank, of Java and GLSL, within a tenth. */
    @Test
    void linesOfCodeAreCurrent() throws IOException {
        for (CloudTechnique technique : built()) {
            String folder = folder(technique);
            long counted = lines(Path.of("engine/src/main/java", folder))
                    + lines(Path.of("engine/src/main/resources", folder));
            long written = Long.parseLong(TechniqueText.of(technique).one("lines"));
            assertTrue(Math.abs(counted - written) <= 0.1 * counted, technique + " has " + counted + " lines of code");
        }
    }

    private static long lines(Path folder) throws IOException {
        long count = 0;
        try (Stream<Path> files = Files.list(folder)) {
            for (Path file : files.toList()) {
                count += Files.readAllLines(file).stream()
                        .filter(line -> !line.isBlank())
                        .count();
            }
        }
        return count;
    }

    /** Levels of pictures exist, options are those of render, and both pictures of a pair have the same view. */
    @Test
    void picturesCanBeDrawn() {
        List<String> known = List.of("--technique", "--eye", "--target", "--fov", "--camera", "--time", "--quality");
        for (CloudTechnique technique : built()) {
            TechniqueText text = TechniqueText.of(technique);
            PictureCommand sample = PictureCommand.of(text.one("sample"));
            assertTrue(Files.exists(Path.of(sample.level())), sample.level());
            for (TechniqueText.Failure failure : text.failures()) {
                PictureCommand wrong = failure.wrong();
                PictureCommand right = failure.right();
                assertTrue(Files.exists(Path.of(wrong.level())), wrong.level());
                assertTrue(known.containsAll(wrong.options().keySet()), wrong.words());
                for (String option : List.of("--eye", "--target", "--fov", "--camera", "--time")) {
                    assertEquals(right.options().get(option), wrong.options().get(option), wrong.words());
                }
                assertEquals(right.level(), wrong.level());
                assertFalse(right.words().equals(wrong.words()), wrong.words());
                wrong.quality();
                right.quality();
            }
        }
    }

    @Test
    void aPictureIsDrawnByTheNamedTechnique() throws IOException {
        Level written = LevelFile.read(Path.of("levels/samples/clouds-skyplane.json"));
        var command = PictureCommand.of("levels/samples/clouds-skyplane.json --technique volume --set cloudStep=2");
        Environment shown = command.drawn(written).environment();
        WeatherClouds.all(shown).forEach(cloud -> assertEquals(CloudTechnique.VOLUME, cloud.technique()));
        assertEquals(written, PictureCommand.of("x.json --time 3").drawn(written));
        assertEquals(3, PictureCommand.of("x.json --time 3").seconds());
        assertEquals("2", command.quality().settings().get("cloudStep"));
    }
}
