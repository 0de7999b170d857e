package nephele.workshop.art;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.Deque;
import javax.imageio.ImageIO;
import nephele.engine.sim.state.PlayerDimensions;
import nephele.lab.generate.TerrainGenerator;
import nephele.workshop.art.picture.PictureRecipe;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

/** The ground of level 06 is what the code makes, and its cliffs let nothing up that walks. */
@Execution(ExecutionMode.CONCURRENT)
class StonesMapTest {
    private static final int SIDE = StonesMap.SIDE;
    private static final float[] HEIGHTS = StonesMap.heights();

    @Test
    void committedMapIsWhatTheCodeMakes() throws IOException {
        byte[] made = TerrainGenerator.png(HEIGHTS, SIDE);
        byte[] kept = Files.readAllBytes(Path.of("assets", StonesMap.FILE));
        assertArrayEquals(samples(made), samples(kept), "run gradle textures");
    }

    @Test
    void committedGrowthIsWhatTheCodePaints() throws IOException {
        for (PictureRecipe recipe : StonesMap.GROWTH) {
            byte[] kept = Files.readAllBytes(Path.of("assets", recipe.file()));
            BufferedImage painted = recipe.painter().get();
            int[] wanted =
                    painted.getRaster().getSamples(0, 0, painted.getWidth(), painted.getHeight(), 0, (int[]) null);
            assertArrayEquals(wanted, samples(kept), recipe.file() + ": run gradle textures");
        }
    }

    private static int[] samples(byte[] png) throws IOException {
        BufferedImage image = ImageIO.read(new ByteArrayInputStream(png));
        return image.getRaster().getSamples(0, 0, image.getWidth(), image.getHeight(), 0, (int[]) null);
    }

    private static int index(double x, double z) {
        return (int) Math.round(2 * (z + 128)) * SIDE + (int) Math.round(2 * (x + 128));
    }

    private static double metres(int index) {
        return StonesMap.MOST_METRES * HEIGHTS[index];
    }

    /** Slopes are differences over a metre. */
    private static boolean isWalkable(int index) {
        double x = metres(index + 1) - metres(index - 1);
        double z = metres(index + SIDE) - metres(index - SIDE);
        return 1 / Math.sqrt(1 + x * x + z * z) > PlayerDimensions.MIN_GROUND_NORMAL_Y;
    }

    /** Returns which samples something that walks, and falls down cliffs, can reach. */
    private static boolean[] reached(int start) {
        boolean[] reached = new boolean[SIDE * SIDE];
        Deque<Integer> open = new ArrayDeque<>();
        open.add(start);
        reached[start] = true;
        while (!open.isEmpty()) {
            int at = open.remove();
            for (int step : new int[] {1, -1, SIDE, -SIDE}) {
                int next = at + step;
                boolean isInside = next % SIDE > 0 && next % SIDE < SIDE - 1 && next > SIDE && next < SIDE * (SIDE - 1);
                if (isInside && !reached[next] && (metres(next) <= metres(at) || isWalkable(next))) {
                    reached[next] = true;
                    open.add(next);
                }
            }
        }
        return reached;
    }

    @Test
    void theGorgeTheRockAndTheMountainsStopAWalk() {
        int start = index(0, 60);
        boolean[] south = reached(start);
        assertTrue(south[index(0, 20)], "down into the gorge");
        assertTrue(reached(index(0, 20))[start], "and back by the ramp");
        assertFalse(south[index(8, -24)], "the temple");
        boolean[] north = reached(index(8, -24));
        assertTrue(north[index(-40, -72)], "the hill");
        assertFalse(north[index(10, -72)], "the rock");
        for (double along = -127; along < 128; along += 1) {
            assertFalse(north[index(along, 126)] || north[index(along, -126)], "a mountain");
            assertFalse(north[index(126, along)] || north[index(-126, along)], "a mountain");
        }
    }
}
