package nephele.workshop.art;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Map;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import nephele.engine.asset.Picture;
import nephele.engine.asset.PictureDecoder;
import nephele.engine.asset.VoxelGrid;
import nephele.workshop.art.bench.BenchPixels;
import nephele.workshop.art.material.TextureRecipe;
import nephele.workshop.art.paint.Surface;
import nephele.workshop.art.picture.PictureRecipe;
import nephele.workshop.art.picture.SignPainter;
import nephele.workshop.art.picture.SkyPainter;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** The pictures in the checkout equal those that the code paints, pixel for pixel, on every JVM. */
@Execution(ExecutionMode.CONCURRENT)
class ArtFilesTest {
    static Stream<String> recipes() {
        return TextureRecipe.ALL.stream().map(TextureRecipe::name);
    }

    @ParameterizedTest
    @MethodSource("recipes")
    void committedTextureIsWhatTheRecipePaints(String name) throws IOException {
        TextureRecipe recipe = recipe(name);
        Surface surface = recipe.paint();
        assertSamePixels(recipe.colourFile(), surface.colourPicture());
        assertSamePixels(recipe.normalFile(), surface.normalPicture());
    }

    @Test
    void committedBenchPicturesAreThePeersPixels() throws IOException {
        for (Map.Entry<String, BufferedImage> picture : ArtFiles.benchPictures().entrySet()) {
            assertSamePixels(picture.getKey(), picture.getValue());
        }
        assertEquals(0xff412d19, BenchPixels.box().getRGB(0, 0), "frame colour and the grain of Content.hash(0, 0, 1)");
    }

    @ParameterizedTest
    @ValueSource(ints = {0, 1, 2, 3, 4, 5})
    void committedSkyIsWhatThePainterPaints(int face) throws IOException {
        assertSamePixels(SkyPainter.files().get(face), new SkyPainter().face(face));
    }

    @Test
    void committedCrossIsWhatThePainterPaints() throws IOException {
        assertSamePixels(SkyPainter.CROSS_FILE, new SkyPainter().cross());
    }

    @Test
    void committedSkiesOfOtherLayoutsAreWhatThePainterPaints() throws IOException {
        for (Map.Entry<String, BufferedImage> painted : SkyPainter.layouts().entrySet()) {
            String id = painted.getKey();
            Picture read = PictureDecoder.decode(id, Files.readAllBytes(Path.of("assets", id)))
                    .toRgba8();
            for (int i = 0; i < read.width() * read.height(); i++) {
                int x = i % read.width();
                int y = i / read.width();
                int rgb = read.sample(x, y, 0) << 16 | read.sample(x, y, 1) << 8 | read.sample(x, y, 2);
                assertEquals(painted.getValue().getRGB(x, y) & 0xffffff, rgb, id + ": run gradle textures");
            }
        }
    }

    @Test
    void committedSignIsWhatThePainterPaints() throws IOException {
        assertSamePixels(SignPainter.FILE, SignPainter.paint());
    }

    @Test
    void committedSamplesAreWhatTheCodeMakes() throws IOException {
        for (Map.Entry<String, byte[]> sample : SampleFiles.all().entrySet()) {
            byte[] file = Files.readAllBytes(Path.of("assets", sample.getKey()));
            assertArrayEquals(sample.getValue(), file, sample.getKey() + ": run gradle textures");
        }
        String grid = "clouds/heap.vol";
        VoxelGrid.read(grid, Files.readAllBytes(Path.of("assets", grid)));
    }

    @Test
    void committedPlantsAreWhatTheCodeGrows() throws IOException {
        for (Map.Entry<String, byte[]> mesh : ArtFiles.plants().entrySet()) {
            assertArrayEquals(
                    mesh.getValue(),
                    Files.readAllBytes(Path.of("assets", mesh.getKey())),
                    mesh.getKey() + ": run gradle textures");
        }
        for (PictureRecipe recipe : ArtFiles.PLANT_PICTURES) {
            assertSamePixels(recipe.file(), recipe.painter().get());
        }
    }

    /** The step across the tile's seam is no larger than steps inside the tile, so that no seam is visible. */
    @ParameterizedTest
    @MethodSource("recipes")
    void textureTilesWithoutASeam(String name) throws IOException {
        int[] picture = pixels(committed(recipe(name).colourFile()));
        int last = Surface.SIDE_TEXELS - 1;
        double acrossX = columnStep(picture, last, 0);
        double acrossY = rowStep(picture, last, 0);
        double insideX = 0;
        double insideY = 0;
        for (int i = 0; i < last; i++) {
            insideX = Math.max(insideX, columnStep(picture, i, i + 1));
            insideY = Math.max(insideY, rowStep(picture, i, i + 1));
        }
        assertTrue(acrossX <= insideX * 1.05 + 1, name + ": column seam " + acrossX + " > " + insideX);
        assertTrue(acrossY <= insideY * 1.05 + 1, name + ": row seam " + acrossY + " > " + insideY);
    }

    private static TextureRecipe recipe(String name) {
        return TextureRecipe.ALL.stream()
                .filter(recipe -> recipe.name().equals(name))
                .findFirst()
                .orElseThrow();
    }

    private static void assertSamePixels(String assetId, BufferedImage painted) throws IOException {
        assertEquals(pixelHash(painted), pixelHash(committed(assetId)), assetId + ": run gradle textures");
    }

    private static BufferedImage committed(String assetId) throws IOException {
        return ImageIO.read(Path.of("assets", assetId).toFile());
    }

    private static int pixelHash(BufferedImage picture) {
        return Arrays.hashCode(pixels(picture));
    }

    private static int[] pixels(BufferedImage picture) {
        int width = picture.getWidth();
        return picture.getRGB(0, 0, width, picture.getHeight(), null, 0, width);
    }

    private static double columnStep(int[] picture, int a, int b) {
        double sum = 0;
        for (int row = 0; row < Surface.SIDE_TEXELS; row++) {
            sum += difference(picture[row * Surface.SIDE_TEXELS + a], picture[row * Surface.SIDE_TEXELS + b]);
        }
        return sum / Surface.SIDE_TEXELS;
    }

    private static double rowStep(int[] picture, int a, int b) {
        double sum = 0;
        for (int column = 0; column < Surface.SIDE_TEXELS; column++) {
            sum += difference(picture[a * Surface.SIDE_TEXELS + column], picture[b * Surface.SIDE_TEXELS + column]);
        }
        return sum / Surface.SIDE_TEXELS;
    }

    private static double difference(int a, int b) {
        return Math.abs((a >> 8 & 255) - (b >> 8 & 255));
    }
}
