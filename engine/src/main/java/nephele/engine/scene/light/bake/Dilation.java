package nephele.engine.scene.light.bake;

/** Fills missing values from the nearest known ones. */
final class Dilation {
    private Dilation() {}

    /** Replaces every NaN, ring by ring, by the mean of its neighbours that are numbers; all by 0 if there is none. */
    static void fill(double[] values, int columns) {
        double[] before = values.clone();
        boolean isChanged = true;
        while (isChanged) {
            isChanged = false;
            for (int i = 0; i < values.length; i++) {
                double mean = Double.isNaN(before[i]) ? neighbourMean(before, columns, i) : Double.NaN;
                if (!Double.isNaN(mean)) {
                    values[i] = mean;
                    isChanged = true;
                }
            }
            System.arraycopy(values, 0, before, 0, values.length);
        }
        for (int i = 0; i < values.length; i++) {
            values[i] = Double.isNaN(values[i]) ? 0 : values[i];
        }
    }

    private static double neighbourMean(double[] values, int columns, int at) {
        int column = at % columns;
        double sum = 0;
        int count = 0;
        for (int i = at - columns; i <= at + columns; i += columns) {
            for (int dx = -1; dx <= 1; dx++) {
                boolean isIn = i >= 0 && i < values.length && column + dx >= 0 && column + dx < columns;
                if (isIn && !Double.isNaN(values[i + dx])) {
                    sum += values[i + dx];
                    count++;
                }
            }
        }
        return count == 0 ? Double.NaN : sum / count;
    }
}
