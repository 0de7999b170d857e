package nephele.engine.choice;

import java.util.List;
import java.util.function.ToDoubleFunction;

/**
 * The measurements of one technique and form on a lattice; linear between its nodes, in the logarithm of the first two
 * axes.
 */
final class ErrorLattice {
    private final List<ErrorTable.Row> rows;
    private final double[] depths;
    private final double[] angles;
    private final double[] suns;

    ErrorLattice(List<ErrorTable.Row> rows) {
        this.rows = List.copyOf(rows);
        depths = axis(ErrorTable.Row::opticalDepth);
        angles = axis(ErrorTable.Row::angularDegrees);
        suns = axis(ErrorTable.Row::sunDegrees);
    }

    private double[] axis(ToDoubleFunction<ErrorTable.Row> of) {
        return rows.stream().mapToDouble(of).distinct().sorted().toArray();
    }

    /** Returns the value at a place of the lattice. */
    double at(double depth, double angle, double sun, ToDoubleFunction<ErrorTable.Row> value) {
        double[] weights = weights(depth, angle, sun);
        double sum = 0;
        double all = 0;
        for (int i = 0; i < weights.length; i++) {
            sum += weights[i] * value.applyAsDouble(rows.get(i));
            all += weights[i];
        }
        return sum / all;
    }

    /** Returns the middle between the value at a place and the greatest of the nodes around it, for values that vary between nodes. */
    double cautiousAt(double depth, double angle, double sun, ToDoubleFunction<ErrorTable.Row> value) {
        double[] weights = weights(depth, angle, sun);
        double greatest = Double.NEGATIVE_INFINITY;
        for (int i = 0; i < weights.length; i++) {
            if (weights[i] > 0) {
                greatest = Math.max(greatest, value.applyAsDouble(rows.get(i)));
            }
        }
        return (at(depth, angle, sun, value) + greatest) / 2;
    }

    /** Returns the weight of each row at a place; if no node around it was measured the nearest one has all. */
    private double[] weights(double depth, double angle, double sun) {
        double alongDepth = place(depths, depth, true);
        double alongAngle = place(angles, angle, true);
        double alongSun = place(suns, sun, false);
        double[] weights = new double[rows.size()];
        double all = 0;
        double least = Double.POSITIVE_INFINITY;
        int nearest = 0;
        for (int i = 0; i < weights.length; i++) {
            ErrorTable.Row row = rows.get(i);
            double byDepth = Math.abs(alongDepth - place(depths, row.opticalDepth(), true));
            double byAngle = Math.abs(alongAngle - place(angles, row.angularDegrees(), true));
            double bySun = Math.abs(alongSun - place(suns, row.sunDegrees(), false));
            weights[i] = tent(byDepth) * tent(byAngle) * tent(bySun);
            all += weights[i];
            if (byDepth + byAngle + bySun < least) {
                least = byDepth + byAngle + bySun;
                nearest = i;
            }
        }
        if (all == 0) {
            weights[nearest] = 1;
        }
        return weights;
    }

    private static double tent(double distance) {
        return Math.max(0, 1 - distance);
    }

    /** Returns a position in nodes along an axis, at most the last one. */
    private static double place(double[] axis, double value, boolean isLogarithmic) {
        for (int i = 1; i < axis.length; i++) {
            if (value < axis[i]) {
                double from = scale(axis[i - 1], isLogarithmic);
                double share = (scale(value, isLogarithmic) - from) / (scale(axis[i], isLogarithmic) - from);
                return i - 1 + Math.max(0, share);
            }
        }
        return axis.length - 1;
    }

    private static double scale(double value, boolean isLogarithmic) {
        return isLogarithmic ? Math.log(Math.max(1e-6, value)) : value;
    }
}
