package nephele.lab.technique;

import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import nephele.engine.asset.AtomicFile;
import nephele.engine.choice.ErrorTable;
import nephele.engine.level.CloudTechnique;

/** What the report on clouds has besides its subjects. */
public final class CloudPages {
    private CloudPages() {}

    /** Returns the section with which the report opens, as HTML. */
    public static String opening(ErrorTable table) {
        return OpeningTable.html(table);
    }

    /**
     * Writes a page about each technique beside the report.
     *
     * @param width of their pictures in pixels
     */
    public static void write(Path folder, int width, int height, PrintStream tell) throws IOException {
        try (var pictures = new PagePictures(folder.resolve("pictures"), width, height, tell)) {
            for (CloudTechnique technique : TechniqueText.ALL) {
                String page = new HandoutPage(TechniqueText.of(technique), pictures).html();
                AtomicFile.write(folder.resolve(HandoutPage.file(technique)), page.getBytes(StandardCharsets.UTF_8));
            }
        }
    }
}
