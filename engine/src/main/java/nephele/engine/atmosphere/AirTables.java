package nephele.engine.atmosphere;

import java.util.function.DoubleConsumer;
import nephele.engine.work.SwingThread;

/** The tables that depend on the air alone: its transmittance and the light that it scatters more than once. Immutable. */
public final class AirTables {
    private final Air air;
    private final SunTransmittance sun;
    private final LightField field;
    private final double[] mieMoments;

    private AirTables(Air air, SunTransmittance sun, LightField field) {
        this.air = air;
        this.sun = sun;
        this.field = field;
        mieMoments = RepeatedScattering.mieMoments(air, field.degree());
    }

    /**
     * Returns the tables. The light field of {@link Air#CLEAR} is a file of the program; that of other air is found or
     * computed, all orders of scattering, which takes seconds of processor time.
     *
     * @param files where computed fields are found and kept
     * @param progress of a computation, 0–1, from several threads; not called without one
     */
    public static AirTables of(Air air, AirFiles files, DoubleConsumer progress) {
        SwingThread.refuse("the light of air");
        SunTransmittance sun = new SunTransmittance(air);
        if (air.isClear()) {
            return new AirTables(air, sun, LightFieldFile.clear().refined());
        }
        String name = LightFieldFile.nameFor(air);
        LightField field = files.find(name)
                .flatMap(bytes -> LightFieldFile.decode(air, bytes))
                .orElse(null);
        if (field == null) {
            field = ScatteringOrders.sum(air, sun, ScatteringOrders.Accuracy.QUICK, progress);
            files.store(name, LightFieldFile.encode(air, field));
        }
        return new AirTables(air, sun, field.refined());
    }

    /** Returns true if the light field of air that is not clear is found. */
    public static boolean isKept(Air air, AirFiles files) {
        return files.find(LightFieldFile.nameFor(air)).isPresent();
    }

    /** Returns the tables, computed unless the air is clear. */
    public static AirTables of(Air air) {
        return of(air, AirFiles.NONE, done -> {});
    }

    public Air air() {
        return air;
    }

    /** Returns the light of the sun for one thread. */
    Sunlight sunlight() {
        return new Sunlight(sun, air.shadowEdgeRadians());
    }

    LightField field() {
        return field;
    }

    double[] mieMoments() {
        return mieMoments;
    }
}
