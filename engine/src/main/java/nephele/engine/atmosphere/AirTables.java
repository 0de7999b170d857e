package nephele.engine.atmosphere;

/** What depends on the air alone: its transmittance and the light that it scatters more than once. Immutable. */
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

    /** Computes the tables, all orders of scattering, which takes seconds of processor time. */
    public static AirTables computed(Air air) {
        SunTransmittance sun = new SunTransmittance(air);
        return new AirTables(air, sun, ScatteringOrders.sum(air, sun).refined());
    }

    /** Returns the tables; those of {@link Air#CLEAR} are read from the program's files, others are computed. */
    public static AirTables of(Air air) {
        return air.equals(Air.CLEAR)
                ? new AirTables(
                        air, new SunTransmittance(air), LightFieldFile.clear().refined())
                : computed(air);
    }

    public Air air() {
        return air;
    }

    SunTransmittance sun() {
        return sun;
    }

    LightField field() {
        return field;
    }

    double[] mieMoments() {
        return mieMoments;
    }
}
