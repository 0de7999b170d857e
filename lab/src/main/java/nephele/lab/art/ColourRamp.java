package nephele.lab.art;

/** A piecewise linear colour gradient. */
final class ColourRamp {
    private final double[] places;
    private final Colour[] colours;

    private ColourRamp(double[] places, Colour[] colours) {
        this.places = places;
        this.colours = colours;
    }

    /** @param evenly colours {@code 0xRRGGBB} from 0 to 1 in equal steps */
    static ColourRamp of(int... evenly) {
        double[] places = new double[evenly.length];
        Colour[] colours = new Colour[evenly.length];
        for (int i = 0; i < evenly.length; i++) {
            places[i] = (double) i / (evenly.length - 1);
            colours[i] = Colour.of(evenly[i]);
        }
        return new ColourRamp(places, colours);
    }

    /** Returns the colour at a place, clamped to 0–1. */
    Colour at(double place) {
        for (int i = 1; i < places.length; i++) {
            if (place < places[i]) {
                double share = Math.max(0, (place - places[i - 1]) / (places[i] - places[i - 1]));
                return colours[i - 1].mix(colours[i], share);
            }
        }
        return colours[colours.length - 1];
    }
}
