package nephele.engine.atmosphere;

/** All sunlight that the air scatters into a ray, as one colour; the phase functions of the ray are included. */
final class AllScattering implements AirSource {
    private final Air air;
    private final SingleScattering once;
    private final RepeatedScattering more;
    private final double[] single = new double[2 * Air.CHANNELS];

    AllScattering(AirTables tables) {
        air = tables.air();
        once = new SingleScattering(air, tables.sunlight());
        more = new RepeatedScattering(air, tables.field(), tables.mieMoments());
    }

    @Override
    public int colours() {
        return 1;
    }

    @Override
    public void put(AirRay ray, double[] radiancePerMetre) {
        more.put(ray, radiancePerMetre);
        once.put(ray, single);
        double rayleigh = Air.rayleighPhase(ray.betweenCosine());
        double mie = air.miePhase(ray.betweenCosine());
        for (int c = 0; c < Air.CHANNELS; c++) {
            radiancePerMetre[c] += rayleigh * single[c] + mie * single[Air.CHANNELS + c];
        }
    }
}
