package nephele.engine.collision.rigid.solver;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

final class BlockCholeskyTest {
    /** For any graph, the matrix times the solution is the right side. */
    @ParameterizedTest
    @CsvSource({"1, 0", "2, 1", "12, 0", "9, 0.3", "20, 0.2", "64, 0", "17, 1"})
    void solvesWhateverIsLinked(int nodes, double share) {
        var random = new SplittableRandom(nodes);
        boolean[][] linked = new boolean[nodes][nodes];
        for (int i = 1; i < nodes; i++) {
            for (int j = 0; j < i; j++) {
                linked[i][j] = j == i - 1 || random.nextDouble() < share;
            }
        }
        var matrix = new BlockCholesky();
        double[][] dense = fill(matrix, linked, random);
        double[] right = random.doubles(6L * nodes, -1, 1).toArray();
        double[] solution = right.clone();
        matrix.factorise();
        matrix.solve(solution);
        for (int row = 0; row < right.length; row++) {
            double sum = 0;
            for (int k = 0; k < right.length; k++) {
                sum += dense[row][k] * solution[k];
            }
            assertEquals(right[row], sum, 1e-9, "row " + row);
        }
    }

    /** Makes a matrix that is the sum of j jᵀ over random rows j of each link, and one on the diagonal. */
    private static double[][] fill(BlockCholesky matrix, boolean[][] linked, SplittableRandom random) {
        int nodes = linked.length;
        matrix.begin(nodes);
        for (int i = 0; i < nodes; i++) {
            for (int j = 0; j < i; j++) {
                if (linked[i][j]) {
                    matrix.link(i, j);
                }
            }
        }
        matrix.analyse();
        matrix.clear();
        double[][] dense = new double[6 * nodes][6 * nodes];
        for (int i = 0; i < 6 * nodes; i++) {
            dense[i][i] = 1;
        }
        for (int a = 0; a < nodes; a++) {
            for (int b = 0; b < a; b++) {
                for (int k = 0; linked[a][b] && k < 3; k++) {
                    addSquare(dense, a, b, random.doubles(12, -1, 1).toArray());
                }
            }
        }
        for (int a = 0; a < nodes; a++) {
            for (int b = 0; b <= a; b++) {
                if (a == b || linked[a][b]) {
                    copy(matrix, dense, a, b);
                }
            }
        }
        return dense;
    }

    private static void addSquare(double[][] dense, int a, int b, double[] row) {
        for (int i = 0; i < 12; i++) {
            for (int j = 0; j < 12; j++) {
                dense[6 * (i < 6 ? a : b) + i % 6][6 * (j < 6 ? a : b) + j % 6] += row[i] * row[j];
            }
        }
    }

    private static void copy(BlockCholesky matrix, double[][] dense, int a, int b) {
        int at = a == b ? matrix.diagonal(a) : matrix.between(a, b);
        boolean rowsOfA = a == b || matrix.hasRowsOf(a, b);
        for (int i = 0; i < 6; i++) {
            for (int j = 0; j < 6; j++) {
                matrix.values()[at + 6 * i + j] = rowsOfA ? dense[6 * a + i][6 * b + j] : dense[6 * b + i][6 * a + j];
            }
        }
    }

    /** A tower takes work linear in its height; bodies that all touch each other take its cube. */
    @ParameterizedTest
    @CsvSource({"10", "40", "64"})
    void aChainIsCheap(int nodes) {
        var matrix = new BlockCholesky();
        matrix.begin(nodes);
        for (int i = 1; i < nodes; i++) {
            matrix.link(i - 1, i);
        }
        assertEquals(2 * (nodes - 1), matrix.analyse());
        matrix.begin(nodes);
        for (int i = 0; i < nodes; i++) {
            for (int j = 0; j < i; j++) {
                matrix.link(i, j);
            }
        }
        assertTrue(matrix.analyse() > nodes * nodes * (nodes - 1) / 6);
    }
}
