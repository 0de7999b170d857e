package nephele.engine.render.frame;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/**
 * What a pass defines for its shaders is a constant of the program, a count that sizes arrays and loops, or a setting of
 * quality; a level's number is a uniform.
 */
class ConstantsInShadersTest {
    private static final List<Path> DRAWING = List.of(
            Path.of("engine/src/main/java/nephele/engine/render"),
            Path.of("scenes/src/main/java/nephele/scenes/fixed"));
    private static final Pattern DEFINED =
            Pattern.compile("(?:\\.with\\(|Map\\.of\\(|, )\\s*\"([A-Z][A-Z_0-9]*)\",\\s*([^;]*?)\\)?(?=\\)\\n"
                    + "|\\)\\)|\\)\\.|\\);|,\\s*\")");
    private static final Pattern CONSTANT =
            Pattern.compile("(\\(double\\) )?([A-Z]\\w*\\.)?[A-Z][A-Z_0-9]*(\\.first\\()?");

    /** Counts of a level and settings of quality, as they stand in the sources. */
    private static final Set<String> COUNTS_AND_SETTINGS = Set.of(
            "materialsPerBlock",
            "maps.layers(",
            "contactSpheres",
            "exits.size(",
            "look.surfaces(",
            "clouds",
            "boxes",
            "SquareSheet.vertices(1",
            "(double) divisor",
            "facing.ordinal(",
            "pixels",
            "textureBias",
            "(double) ImpostorAtlas.texelsFor(pixels",
            "\"\"",
            "FontAtlas.WIDTH_TEXELS + \".0\"",
            "FontAtlas.HEIGHT_TEXELS + \".0\"",
            "Integer.toString(BillboardList.PER_SHEET");

    @Test
    void whatIsDefinedIsNoNumberOfALevel() throws IOException {
        List<String> wrong = new ArrayList<>();
        int count = 0;
        for (Path folder : DRAWING) {
            for (Path file : sources(folder)) {
                Matcher defined = DEFINED.matcher(Files.readString(file));
                while (defined.find()) {
                    count++;
                    String value = defined.group(2).strip();
                    if (!CONSTANT.matcher(value).matches() && !COUNTS_AND_SETTINGS.contains(value)) {
                        wrong.add(file.getFileName() + ": " + defined.group(1) + " = " + value);
                    }
                }
            }
        }
        assertEquals(List.of(), wrong);
        assertTrue(count > 40, count + " definitions were found");
    }

    private static List<Path> sources(Path folder) throws IOException {
        try (Stream<Path> files = Files.walk(folder)) {
            return files.filter(each -> each.toString().endsWith(".java")).toList();
        }
    }
}
