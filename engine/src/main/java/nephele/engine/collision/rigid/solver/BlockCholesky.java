package nephele.engine.collision.rigid.solver;

import java.util.Arrays;

/**
 * Sparse Cholesky factorisation of a symmetric positive definite matrix of 6 × 6 blocks, one block row for each body.
 * Bodies are eliminated in order of least degree (Tinney and Walker 1967), so that the cost of a tower is linear in its
 * height. Reused for every island.
 */
final class BlockCholesky {
    /** Limit of the nodes: the graph's rows are bit masks. */
    static final int MOST_NODES = 64;

    /** Rows and columns of a block: six numbers of velocity a body. */
    static final int SIZE = SolverState.STRIDE;

    private static final int BLOCK = SIZE * SIZE;

    private final long[] linked = new long[MOST_NODES];
    private final int[] order = new int[MOST_NODES];
    private final int[] place = new int[MOST_NODES];
    /** For each place in the order, the later places with non-zero blocks in that column. */
    private final long[] column = new long[MOST_NODES];

    private final int[] blockAt = new int[MOST_NODES * MOST_NODES];
    private double[] block = new double[16 * BLOCK];
    private final double[] solution = new double[SIZE * MOST_NODES];
    private int nodes;
    private int blocks;
    private int updates;

    /** Begins the graph of an island of bodies without links. */
    void begin(int bodies) {
        nodes = bodies;
        Arrays.fill(linked, 0, nodes, 0);
    }

    void link(int a, int b) {
        linked[a] |= 1L << b;
        linked[b] |= 1L << a;
    }

    /** Chooses the order and finds the fill-in; returns the number of block products of a factorisation. */
    int analyse() {
        long left = nodes == MOST_NODES ? -1L : (1L << nodes) - 1;
        updates = 0;
        for (int at = 0; at < nodes; at++) {
            int best = leastDegree(left);
            left &= ~(1L << best);
            order[at] = best;
            place[best] = at;
            long others = linked[best] & left;
            column[at] = others;
            int degree = Long.bitCount(others);
            updates += degree * (degree + 3) / 2;
            for (long rest = others; rest != 0; rest &= rest - 1) {
                int other = Long.numberOfTrailingZeros(rest);
                linked[other] |= others & ~(1L << other);
            }
        }
        nameBlocks();
        return updates;
    }

    private int leastDegree(long left) {
        int best = -1;
        int least = Integer.MAX_VALUE;
        for (long rest = left; rest != 0; rest &= rest - 1) {
            int node = Long.numberOfTrailingZeros(rest);
            int degree = Long.bitCount(linked[node] & left & ~(1L << node));
            if (degree < least) {
                least = degree;
                best = node;
            }
        }
        return best;
    }

    /** Converts the columns' masks from bodies to places and allots room to every non-zero block. */
    private void nameBlocks() {
        blocks = 0;
        for (int at = 0; at < nodes; at++) {
            long places = 0;
            blockAt[at * MOST_NODES + at] = BLOCK * blocks++;
            for (long rest = column[at]; rest != 0; rest &= rest - 1) {
                int below = place[Long.numberOfTrailingZeros(rest)];
                places |= 1L << below;
                blockAt[below * MOST_NODES + at] = BLOCK * blocks++;
            }
            column[at] = places;
        }
        if (block.length < BLOCK * blocks) {
            block = new double[2 * BLOCK * blocks];
        }
    }

    /** Sets the whole matrix to zero. */
    void clear() {
        Arrays.fill(block, 0, BLOCK * blocks, 0);
    }

    /** Returns the array of the blocks, by rows; a block off the diagonal has the rows of the body eliminated later. */
    double[] values() {
        return block;
    }

    /** Returns the index at which the diagonal block of a body begins. */
    int diagonal(int node) {
        return blockAt[place[node] * MOST_NODES + place[node]];
    }

    /** Returns true if the block of two linked bodies has the rows of the first. */
    boolean hasRowsOf(int a, int b) {
        return place[a] > place[b];
    }

    /** Returns the index at which the block of two linked bodies begins. */
    int between(int a, int b) {
        int i = Math.max(place[a], place[b]);
        int j = Math.min(place[a], place[b]);
        return blockAt[i * MOST_NODES + j];
    }

    /** Replaces the matrix by its factor: right-looking, block by block. */
    void factorise() {
        for (int k = 0; k < nodes; k++) {
            int pivot = blockAt[k * MOST_NODES + k];
            factoriseBlock(pivot);
            for (long rest = column[k]; rest != 0; rest &= rest - 1) {
                divide(blockAt[Long.numberOfTrailingZeros(rest) * MOST_NODES + k], pivot);
            }
            for (long rest = column[k]; rest != 0; rest &= rest - 1) {
                int j = Long.numberOfTrailingZeros(rest);
                int columnBlock = blockAt[j * MOST_NODES + k];
                for (long below = rest; below != 0; below &= below - 1) {
                    int i = Long.numberOfTrailingZeros(below);
                    subtractProduct(blockAt[i * MOST_NODES + j], blockAt[i * MOST_NODES + k], columnBlock);
                }
            }
        }
    }

    /** Replaces a right side of six numbers for each body by the solution. */
    void solve(double[] rightSide) {
        for (int at = 0; at < nodes; at++) {
            System.arraycopy(rightSide, SIZE * order[at], solution, SIZE * at, SIZE);
        }
        for (int k = 0; k < nodes; k++) {
            forward(blockAt[k * MOST_NODES + k], SIZE * k);
            for (long rest = column[k]; rest != 0; rest &= rest - 1) {
                int i = Long.numberOfTrailingZeros(rest);
                subtract(blockAt[i * MOST_NODES + k], SIZE, 1, SIZE * k, SIZE * i);
            }
        }
        for (int k = nodes - 1; k >= 0; k--) {
            for (long rest = column[k]; rest != 0; rest &= rest - 1) {
                int i = Long.numberOfTrailingZeros(rest);
                subtract(blockAt[i * MOST_NODES + k], 1, SIZE, SIZE * i, SIZE * k);
            }
            backward(blockAt[k * MOST_NODES + k], SIZE * k);
        }
        for (int at = 0; at < nodes; at++) {
            System.arraycopy(solution, SIZE * at, rightSide, SIZE * order[at], SIZE);
        }
    }

    /** Replaces a diagonal block by its lower factor, with reciprocals on the diagonal. */
    private void factoriseBlock(int at) {
        double[] m = block;
        for (int j = 0; j < SIZE; j++) {
            int rowJ = at + SIZE * j;
            double d = m[rowJ + j];
            for (int k = 0; k < j; k++) {
                d -= m[rowJ + k] * m[rowJ + k];
            }
            double reciprocal = d > 0 ? 1 / Math.sqrt(d) : 0;
            m[rowJ + j] = reciprocal;
            for (int i = j + 1; i < SIZE; i++) {
                int rowI = at + SIZE * i;
                double sum = m[rowI + j];
                for (int k = 0; k < j; k++) {
                    sum -= m[rowI + k] * m[rowJ + k];
                }
                m[rowI + j] = sum * reciprocal;
            }
        }
    }

    /** Multiplies a block by the transposed inverse of a factor from the right. */
    private void divide(int at, int factor) {
        double[] m = block;
        for (int row = at; row < at + BLOCK; row += SIZE) {
            for (int j = 0; j < SIZE; j++) {
                int rowJ = factor + SIZE * j;
                double sum = m[row + j];
                for (int k = 0; k < j; k++) {
                    sum -= m[row + k] * m[rowJ + k];
                }
                m[row + j] = sum * m[rowJ + j];
            }
        }
    }

    private void subtractProduct(int to, int left, int right) {
        double[] m = block;
        for (int i = 0; i < SIZE; i++) {
            int l = left + SIZE * i;
            double l0 = m[l];
            double l1 = m[l + 1];
            double l2 = m[l + 2];
            double l3 = m[l + 3];
            double l4 = m[l + 4];
            double l5 = m[l + 5];
            int t = to + SIZE * i;
            for (int j = 0; j < SIZE; j++) {
                int r = right + SIZE * j;
                m[t + j] -= l0 * m[r] + l1 * m[r + 1] + l2 * m[r + 2] + l3 * m[r + 3] + l4 * m[r + 4] + l5 * m[r + 5];
            }
        }
    }

    private void forward(int factor, int at) {
        for (int j = 0; j < SIZE; j++) {
            double sum = solution[at + j];
            for (int k = 0; k < j; k++) {
                sum -= block[factor + SIZE * j + k] * solution[at + k];
            }
            solution[at + j] = sum * block[factor + SIZE * j + j];
        }
    }

    private void backward(int factor, int at) {
        for (int j = SIZE - 1; j >= 0; j--) {
            double sum = solution[at + j];
            for (int k = j + 1; k < SIZE; k++) {
                sum -= block[factor + SIZE * k + j] * solution[at + k];
            }
            solution[at + j] = sum * block[factor + SIZE * j + j];
        }
    }

    /** Subtracts the product of a block and a part of the solution from another part. */
    private void subtract(int of, int rowStride, int columnStride, int from, int to) {
        for (int i = 0; i < SIZE; i++) {
            double sum = 0;
            for (int j = 0; j < SIZE; j++) {
                sum += block[of + rowStride * i + columnStride * j] * solution[from + j];
            }
            solution[to + i] -= sum;
        }
    }
}
