package nephele.engine.choice;

import java.util.List;
import java.util.function.ToDoubleFunction;

/** The measurements of one technique and form on a lattice; linear between its nodes, in the logarithm of the first two axes. Where nodes are missing the nearest one counts. */
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

    double at(double depth, double angle, double sun, ToDoubleFunction<ErrorTable.Row> value) {
        double alongDepth = place(depths, depth, true);
        double alongAngle = place(angles, angle, true);
        double alongSun = place(suns, sun, false);
        double sum = 0;
        double weights = 0;
        double nearest = 0;
        double least = Double.POSITIVE_INFINITY;
        for (ErrorTable.Row row : rows) {
            double byDepth = Math.abs(alongDepth - place(depths, row.opticalDepth(), true));
            double byAngle = Math.abs(alongAngle - place(angles, row.angularDegrees(), true));
            double bySun = Math.abs(alongSun - place(suns, row.sunDegrees(), false));
            double weight = tent(byDepth) * tent(byAngle) * tent(bySun);
            sum += weight * value.applyAsDouble(row);
            weights += weight;
            double distance = byDepth + byAngle + bySun;
            if (distance < least) {
                least = distance;
                nearest = value.applyAsDouble(row);
            }
        }
        return weights > 0 ? sum / weights : nearest;
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
