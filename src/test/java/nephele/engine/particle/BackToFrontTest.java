package nephele.engine.particle;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.Comparator;
import java.util.Random;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

/** The order is that of a stable comparison sort of the quantised distances. */
@Execution(ExecutionMode.CONCURRENT)
class BackToFrontTest {
    private static int[] sorted(BackToFront order, float[] distances) {
        order.begin(distances.length);
        for (int i = 0; i < distances.length; i++) {
            order.add(i, distances[i]);
        }
        order.sort();
        return IntStream.range(0, order.count()).map(order::at).toArray();
    }

    private static int[] expected(float[] distances) {
        return IntStream.range(0, distances.length)
                .boxed()
                .sorted(Comparator.comparing(i -> -(Float.floatToRawIntBits(distances[i]) >>> 9)))
                .mapToInt(Integer::intValue)
                .toArray();
    }

    @Test
    void itIsTheStableSortOfSeveralLists() {
        Random random = new Random(3);
        BackToFront order = new BackToFront();
        for (int count : new int[] {0, 1, 2, 1000, 7, 50_000}) {
            float[] distances = new float[count];
            for (int i = 0; i < count; i++) {
                // From 1e-20 to 1e12, a quarter of them equal.
                distances[i] = random.nextInt(4) == 0 ? 9 : (float) Math.pow(10, 32 * random.nextDouble() - 20);
            }
            assertArrayEquals(expected(distances), sorted(order, distances));
        }
    }

    @Test
    void extremesAndEqualOnesKeepTheirOrder() {
        float[] distances = {0, Float.MAX_VALUE, 0, Float.MIN_VALUE, Float.MAX_VALUE, 1};
        assertArrayEquals(new int[] {1, 4, 5, 0, 2, 3}, sorted(new BackToFront(), distances));
        float[] equal = new float[300];
        Arrays.fill(equal, 2.5f);
        assertArrayEquals(IntStream.range(0, 300).toArray(), sorted(new BackToFront(), equal));
    }

    @Test
    void distancesThatDifferByAThirtyThousandthAreOrdered() {
        for (float squared = 1e-6f; squared < 1e9f; squared *= 7.3f) {
            float farther = squared * 1.0002f;
            assertArrayEquals(new int[] {1, 0}, sorted(new BackToFront(), new float[] {squared, farther}));
            assertTrue(farther > squared);
        }
    }
}
