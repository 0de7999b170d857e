package nephele.engine.model.file;

import java.util.Arrays;

/** Rows of equally many numbers, each with its line in the file. */
final class NumberRows {
    private final int width;
    private float[] numbers = new float[48];
    private int[] lines = new int[16];
    private int rows;

    NumberRows(int width) {
        this.width = width;
    }

    int width() {
        return width;
    }

    int rows() {
        return rows;
    }

    int line(int row) {
        return lines[row];
    }

    float at(int row, int column) {
        return numbers[row * width + column];
    }

    void add(int line, float[] row) {
        if (rows == lines.length) {
            lines = Arrays.copyOf(lines, 2 * rows);
        }
        if ((rows + 1) * width > numbers.length) {
            numbers = Arrays.copyOf(numbers, 2 * (rows + 1) * width);
        }
        System.arraycopy(row, 0, numbers, rows * width, width);
        lines[rows++] = line;
    }

    float[] toArray() {
        return Arrays.copyOf(numbers, rows * width);
    }
}
