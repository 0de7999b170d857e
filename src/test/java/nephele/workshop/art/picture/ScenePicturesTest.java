package nephele.workshop.art.picture;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * The scenes' pictures equal those that the code paints, on every JVM, and globes have neither a seam nor distorted
 * poles.
 */
@Execution(ExecutionMode.CONCURRENT)
class ScenePicturesTest {
    private static final Path ASSETS = Path.of("assets");
    private static final String GLOBE =
            ".*/(sun|mercury|venus|earth|moon|mars|jupiter|io|europa|saturn|uranus|neptune)\\.png";
    private static final long MOST_BYTES = 6 << 20;

    static Stream<PictureRecipe> recipes() {
        return ScenePictures.ALL.stream();
    }

    @ParameterizedTest
    @MethodSource("recipes")
    void committedPictureIsWhatTheRecipePaints(PictureRecipe recipe) throws IOException {
        BufferedImage painted = recipe.painter().get();
        assertArrayEquals(pixels(painted), pixels(committed(recipe)), recipe.file() + ": run gradle textures");
    }

    static Stream<PictureRecipe> globes() {
        return recipes().filter(recipe -> recipe.file().matches(GLOBE));
    }

    @ParameterizedTest
    @MethodSource("globes")
    void aWorldHasNoSeam(PictureRecipe recipe) throws IOException {
        BufferedImage picture = committed(recipe);
        int last = picture.getWidth() - 1;
        double inside = 0;
        for (int column = 0; column < last; column++) {
            inside = Math.max(inside, columnStep(picture, column, column + 1));
        }
        double across = columnStep(picture, last, 0);
        assertTrue(across <= inside * 1.05 + 0.5, recipe.file() + ": seam " + across + " > " + inside);
    }

    /** The first row is nearly one point of the globe; it is half a row from the pole. */
    @ParameterizedTest
    @MethodSource("globes")
    void aWorldIsOfOneColourAtEachPole(PictureRecipe recipe) throws IOException {
        BufferedImage picture = committed(recipe);
        for (int row : new int[] {0, picture.getHeight() - 1}) {
            int least = 255;
            int most = 0;
            for (int column = 0; column < picture.getWidth(); column++) {
                int green = green(picture, column, row);
                least = Math.min(least, green);
                most = Math.max(most, green);
            }
            assertTrue(most - least <= 24, recipe.file() + " row " + row + ": " + least + " to " + most);
        }
    }

    @Test
    void thePicturesAreSmall() throws IOException {
        long bytes = 0;
        for (PictureRecipe recipe : ScenePictures.ALL) {
            bytes += Files.size(ASSETS.resolve(recipe.file()));
        }
        assertTrue(bytes <= MOST_BYTES, bytes + " bytes");
    }

    @Test
    void theGridsEdgesAndNumbersSayWhereTheyAre() {
        BufferedImage grid = NumberedGrid.paint();
        assertEquals(0xffd8342c, grid.getRGB(0, 256), "left");
        assertEquals(0xff27a35a, grid.getRGB(511, 256), "right");
        assertEquals(0xff2f62d8, grid.getRGB(256, 0), "top");
        assertEquals(0xfff0c020, grid.getRGB(256, 511), "bottom");
        assertTrue(NumberedGrid.hasDot(7, 4, 1) && !NumberedGrid.hasDot(7, 0, 1), "a seven leans to the right");
    }

    private static BufferedImage committed(PictureRecipe recipe) throws IOException {
        return ImageIO.read(ASSETS.resolve(recipe.file()).toFile());
    }

    private static int[] pixels(BufferedImage picture) {
        return picture.getRGB(0, 0, picture.getWidth(), picture.getHeight(), null, 0, picture.getWidth());
    }

    private static double columnStep(BufferedImage picture, int a, int b) {
        double sum = 0;
        for (int row = 0; row < picture.getHeight(); row++) {
            sum += Math.abs(green(picture, a, row) - green(picture, b, row));
        }
        return sum / picture.getHeight();
    }

    private static int green(BufferedImage picture, int column, int row) {
        return picture.getRGB(column, row) >> 8 & 255;
    }
}
