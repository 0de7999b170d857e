package nephele.engine.atmosphere;

/** All sunlight that the air scatters into a ray, as one colour; the phase functions of the ray are included. */
final class AllScattering implements AirSource {
    private final FirstScattering once;
    private final RepeatedScattering more;
    private final double[] single = new double[Air.CHANNELS];

    AllScattering(AirTables tables) {
        once = new FirstScattering(tables);
        more = new RepeatedScattering(tables.air(), tables.field(), tables.mieMoments());
    }

    @Override
    public int colours() {
        return 1;
    }

    @Override
    public void put(AirRay ray, double[] radiancePerMetre) {
        more.put(ray, radiancePerMetre);
        once.put(ray, single);
        for (int c = 0; c < Air.CHANNELS; c++) {
            radiancePerMetre[c] += single[c];
        }
    }
}
