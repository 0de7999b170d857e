package nephele.engine.model.file;

import java.nio.ByteBuffer;

/**
 * The numbers of an accessor (glTF 2.0, 3.6.2), validated to be within its buffer views. No number is read before
 * {@link #numbers}, so that an accessor costs nothing before its count is known to be affordable.
 *
 * @param dense {@code null} for zeros
 * @param sparse replaces some elements, {@code null} without them
 */
record GltfAccessor(GltfValue authored, int count, int width, Elements dense, Sparse sparse) {
    static final int BYTE = 5120;
    static final int UNSIGNED_BYTE = 5121;
    static final int SHORT = 5122;
    static final int UNSIGNED_SHORT = 5123;
    static final int UNSIGNED_INT = 5125;
    static final int FLOAT = 5126;

    /** Elements at equal distances in a buffer; {@code first} and {@code stride} are in bytes. */
    record Elements(ByteBuffer buffer, int first, int stride, Format format) {
        double number(int element, int column) {
            return format.number(buffer, first + element * stride + column * format.bytes());
        }
    }

    /** The elements that differ from {@code dense}: their indices, which rise, and their values. */
    record Sparse(GltfValue authored, int count, Elements indices, Elements values) {}

    /** The type of a component; normalized integers stand for 0 to 1 or -1 to 1. */
    record Format(int component, boolean isNormalized) {
        int bytes() {
            return switch (component) {
                case BYTE, UNSIGNED_BYTE -> 1;
                case SHORT, UNSIGNED_SHORT -> 2;
                default -> 4;
            };
        }

        private double number(ByteBuffer buffer, int at) {
            return switch (component) {
                case BYTE -> isNormalized ? Math.max(buffer.get(at) / 127.0, -1) : buffer.get(at);
                case UNSIGNED_BYTE -> (buffer.get(at) & 0xff) / (isNormalized ? 255.0 : 1);
                case SHORT -> isNormalized ? Math.max(buffer.getShort(at) / 32_767.0, -1) : buffer.getShort(at);
                case UNSIGNED_SHORT -> (buffer.getShort(at) & 0xffff) / (isNormalized ? 65_535.0 : 1);
                case UNSIGNED_INT -> Integer.toUnsignedLong(buffer.getInt(at));
                default -> buffer.getFloat(at);
            };
        }
    }

    /** Returns all numbers, element by element. */
    double[] numbers() {
        double[] numbers = new double[count * width];
        for (int i = 0; dense != null && i < count; i++) {
            for (int column = 0; column < width; column++) {
                numbers[i * width + column] = dense.number(i, column);
            }
        }
        if (sparse != null) {
            replace(numbers);
        }
        return numbers;
    }

    private void replace(double[] numbers) {
        int last = -1;
        for (int i = 0; i < sparse.count; i++) {
            double index = sparse.indices.number(i, 0);
            if (index <= last || index >= count) {
                throw sparse.authored
                        .member("indices")
                        .error("do not rise from 0 to " + (count - 1) + ": index " + (long) index + " at " + i);
            }
            last = (int) index;
            for (int column = 0; column < width; column++) {
                numbers[last * width + column] = sparse.values.number(i, column);
            }
        }
    }
}
