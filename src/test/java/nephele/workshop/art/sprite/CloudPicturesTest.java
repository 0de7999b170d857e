package nephele.workshop.art.sprite;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.stream.Stream;
import nephele.engine.asset.Picture;
import nephele.engine.asset.PictureDecoder;
import nephele.workshop.art.picture.PictureRecipe;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** The pictures and the grid of clouds equal those that the code makes, and what a layer repeats has no seam. */
class CloudPicturesTest {
    private static final Path ASSETS = Path.of("assets");

    static Stream<PictureRecipe> recipes() {
        return CloudPictures.ALL.stream();
    }

    private static Picture committed(String file) throws IOException {
        return PictureDecoder.decode(file, Files.readAllBytes(ASSETS.resolve(file)));
    }

    @ParameterizedTest
    @MethodSource("recipes")
    void committedPictureIsWhatTheRecipePaints(PictureRecipe recipe) throws IOException {
        var painted = recipe.painter().get();
        Picture picture = committed(recipe.file());
        int bands = painted.getRaster().getNumBands();
        assertEquals(bands, picture.channels());
        for (int y = 0; y < painted.getHeight(); y++) {
            for (int x = 0; x < painted.getWidth(); x++) {
                for (int band = 0; band < bands; band++) {
                    assertEquals(
                            painted.getRaster().getSample(x, y, band),
                            picture.sample(x, y, band),
                            recipe.file() + ": run gradle textures");
                }
            }
        }
    }

    @ParameterizedTest
    @MethodSource("recipes")
    void aRepeatedPictureHasNoSeam(PictureRecipe recipe) throws IOException {
        Picture picture = committed(recipe.file());
        int channel = picture.channels() - 1;
        int side = picture.width();
        double[] columns = new double[side];
        double[] rows = new double[side];
        for (int i = 0; i < side; i++) {
            for (int j = 0; j < side; j++) {
                columns[i] += Math.abs(picture.sample(i, j, channel) - picture.sample((i + 1) % side, j, channel));
                rows[i] += Math.abs(picture.sample(j, i, channel) - picture.sample(j, (i + 1) % side, channel));
            }
        }
        for (double[] steps : new double[][] {columns, rows}) {
            double inside = Arrays.stream(steps, 0, side - 1).max().orElseThrow();
            assertTrue(steps[side - 1] <= 1.05 * inside, recipe.file() + ": " + steps[side - 1] + " of " + inside);
        }
    }
}
