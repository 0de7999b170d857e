package nephele.workshop.art.paint;

/** A piecewise linear colour gradient. */
public final class ColourRamp {
    private final double[] places;
    private final PaintColour[] colours;

    private ColourRamp(double[] places, PaintColour[] colours) {
        this.places = places;
        this.colours = colours;
    }

    /** @param evenly colours {@code 0xRRGGBB} from 0 to 1 in equal steps */
    public static ColourRamp of(int... evenly) {
        double[] places = new double[evenly.length];
        PaintColour[] colours = new PaintColour[evenly.length];
        for (int i = 0; i < evenly.length; i++) {
            places[i] = (double) i / (evenly.length - 1);
            colours[i] = PaintColour.of(evenly[i]);
        }
        return new ColourRamp(places, colours);
    }

    /** Returns the colour at a place, clamped to 0–1. */
    public PaintColour at(double place) {
        for (int i = 1; i < places.length; i++) {
            if (place < places[i]) {
                double fraction = Math.max(0, (place - places[i - 1]) / (places[i] - places[i - 1]));
                return colours[i - 1].mix(colours[i], fraction);
            }
        }
        return colours[colours.length - 1];
    }
}
