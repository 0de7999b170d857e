package nephele.engine.choice;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.function.ToDoubleFunction;
import nephele.engine.asset.AssetException;
import nephele.engine.asset.AssetSource;
import nephele.engine.asset.TextFile;
import nephele.engine.level.CloudTechnique;

/**
 * Measured errors and costs of techniques, by the form of a cloud, its optical depth, its angular size and the sun's
 * elevation. Between measured values it interpolates, beyond them it keeps the last one. Immutable.
 */
public final class ErrorTable {
    public static final String HEADER = "form,technique,opticalDepth,angularDegrees,sunDegrees,errorPercent,cost";

    /** Name of the table, also of one in a folder of levels. */
    public static final String FILE = "technique-errors.csv";

    private final List<Row> rows;
    private final Map<String, ErrorLattice> grids = new LinkedHashMap<>();

    /**
     * One measurement.
     *
     * @param errorPercent root mean square of the radiance's error over blocks of a tenth of the picture's width that
     *     show the cloud, in per cent of the mean radiance there
     * @param cost CPU time of a frame that the clouds add, in those of the quad of {@code bench --calibrate}
     */
    public record Row(
            String form,
            CloudTechnique technique,
            double opticalDepth,
            double angularDegrees,
            double sunDegrees,
            double errorPercent,
            double cost) {
        String line() {
            return String.join(
                    ",",
                    form,
                    technique.name().toLowerCase(Locale.ROOT),
                    number(opticalDepth),
                    number(angularDegrees),
                    number(sunDegrees),
                    String.format(Locale.ROOT, "%.2f", errorPercent),
                    String.format(Locale.ROOT, "%.3f", cost));
        }

        private static String number(double value) {
            return value == Math.rint(value) ? Long.toString((long) value) : Double.toString(value);
        }
    }

    public ErrorTable(List<Row> measured) {
        rows = List.copyOf(measured);
        Map<String, List<Row>> byKey = new LinkedHashMap<>();
        rows.forEach(row -> byKey.computeIfAbsent(key(row.form(), row.technique()), known -> new ArrayList<>())
                .add(row));
        byKey.forEach((key, list) -> grids.put(key, new ErrorLattice(list)));
    }

    /** Reads the table that is shipped. */
    public static ErrorTable shipped() {
        try (InputStream in = ErrorTable.class.getResourceAsStream(FILE);
                var lines = new BufferedReader(new InputStreamReader(in, StandardCharsets.UTF_8))) {
            return read(lines.lines().toList(), FILE);
        } catch (IOException failure) {
            throw new UncheckedIOException(failure);
        }
    }

    /**
     * Reads a table.
     *
     * @throws IllegalArgumentException that names the file and the line of what is no row
     */
    public static ErrorTable read(List<String> lines, String file) {
        if (lines.isEmpty() || !lines.get(0).equals(HEADER)) {
            throw new IllegalArgumentException(file + ": line 1: must be " + HEADER);
        }
        List<Row> rows = new ArrayList<>();
        for (int i = 1; i < lines.size(); i++) {
            try {
                rows.add(row(lines.get(i).split(",", -1)));
            } catch (IllegalArgumentException | ArrayIndexOutOfBoundsException failure) {
                throw new IllegalArgumentException(file + ": line " + (i + 1) + ": is no row of the table", failure);
            }
        }
        return new ErrorTable(rows);
    }

    private static Row row(String[] cells) {
        return new Row(
                cells[0],
                CloudTechnique.valueOf(cells[1].toUpperCase(Locale.ROOT)),
                Double.parseDouble(cells[2]),
                Double.parseDouble(cells[3]),
                Double.parseDouble(cells[4]),
                Double.parseDouble(cells[5]),
                Double.parseDouble(cells[6]));
    }

    public List<Row> rows() {
        return rows;
    }

    /** Returns the table as the lines of a file. */
    public List<String> lines() {
        List<String> lines = new ArrayList<>();
        lines.add(HEADER);
        rows.forEach(row -> lines.add(row.line()));
        return lines;
    }

    /**
     * Returns the table for the levels of a folder: the shipped one, refined by the folder's own if there is one.
     *
     * @throws AssetException that names the file and the line of what is no row
     */
    public static ErrorTable of(AssetSource assets) {
        ErrorTable shipped = shipped();
        if (!assets.exists(FILE)) {
            return shipped;
        }
        try {
            return shipped.refined(
                    read(TextFile.text(assets.bytes(FILE)).lines().toList(), FILE));
        } catch (TextFile.NotUtf8 noText) {
            throw new AssetException(FILE, "can't be read", noText.getMessage());
        } catch (IllegalArgumentException failure) {
            throw new AssetException(
                    FILE, failure.getMessage(), "delete it, or make it again with `trade clouds --level`", failure);
        }
    }

    /** Returns true if it has rows of a form. */
    boolean knows(String form) {
        return rows.stream().anyMatch(row -> row.form().equals(form));
    }

    /** Returns this table with other rows in the place of its own of the same form and technique. */
    public ErrorTable refined(ErrorTable by) {
        List<Row> kept = new ArrayList<>(rows);
        kept.removeIf(row -> by.grids.containsKey(key(row.form(), row.technique())));
        kept.addAll(by.rows);
        return new ErrorTable(kept);
    }

    /**
     * Returns the error of a technique in per cent; empty if it was not measured for such clouds. Between nodes it is
     * nearer to the greatest around: errors of clouds in wrong places vary at random.
     */
    public OptionalDouble errorPercent(CloudTechnique technique, CloudSituation at) {
        ErrorLattice grid = grids.get(key(at.form(), technique));
        return grid == null
                ? OptionalDouble.empty()
                : OptionalDouble.of(
                        grid.cautiousAt(at.opticalDepth(), at.angularDegrees(), at.sunDegrees(), Row::errorPercent));
    }

    /** Returns the cost of a technique; empty if it was not measured for such clouds. */
    public OptionalDouble cost(CloudTechnique technique, CloudSituation at) {
        ErrorLattice grid = grids.get(key(at.form(), technique));
        return grid == null
                ? OptionalDouble.empty()
                : OptionalDouble.of(grid.at(at.opticalDepth(), at.angularDegrees(), at.sunDegrees(), Row::cost));
    }

    private static String key(String form, CloudTechnique technique) {
        return form + ", " + technique;
    }

    /**
     * The measurements of one technique and form on a lattice; linear between its nodes, in the logarithm of the first two
     * axes.
     */
    private static final class ErrorLattice {
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
                    double fraction = (scale(value, isLogarithmic) - from) / (scale(axis[i], isLogarithmic) - from);
                    return i - 1 + Math.max(0, fraction);
                }
            }
            return axis.length - 1;
        }

        private static double scale(double value, boolean isLogarithmic) {
            return isLogarithmic ? Math.log(Math.max(1e-6, value)) : value;
        }
    }
}
