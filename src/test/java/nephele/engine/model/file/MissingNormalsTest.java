package nephele.engine.model.file;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;

import org.junit.jupiter.api.Test;

class MissingNormalsTest {
    /** At a cube's corner the normal is the diagonal, even if one of the faces is cut into two triangles there. */
    @Test
    void aFaceCutIntoMoreTrianglesWeighsNoMore() {
        float[] positions = {0, 0, 0, -1, 0, 0, 0, -1, 0, 0, 0, -1, -1, -1, 0};
        int[] three = {0, 1, 2, 0, 2, 3, 0, 3, 1};
        int[] four = {0, 1, 4, 0, 4, 2, 0, 2, 3, 0, 3, 1};
        float third = (float) (1 / Math.sqrt(3));
        for (int[] indices : new int[][] {three, four}) {
            float[] normals = new float[15];
            for (int other = 1; other < 5; other++) {
                normals[3 * other] = 1;
            }
            MissingNormals.fill(positions, normals, indices);
            assertArrayEquals(new float[] {third, third, third, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0}, normals, 1e-6f);
        }
    }

    @Test
    void whatHasNoAreaLooksUpAndWhatIsLongIsMadeUnit() {
        float[] normals = {0, 0, 0, 0, 0, 8, 0, 0, 0};
        MissingNormals.fill(new float[] {0, 0, 0, 1, 0, 0, 2, 0, 0}, normals, new int[] {0, 1, 2});
        assertArrayEquals(new float[] {0, 1, 0, 0, 0, 1, 0, 1, 0}, normals);
    }
}
