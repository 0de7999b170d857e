package nephele.lab.generate;

/** The surfaces of plants and rocks: each is a row of the shared palette picture, shaded from dark to light. */
public enum PlantPaint {
    OAK_BARK(0x3E3932, 0x645C52, 0x8A8276),
    BIRCH_BARK(0x34312E, 0x9C958A, 0xD8D2C6, 0xE9E4DA),
    FIR_BARK(0x38312B, 0x584C42, 0x786B5E),
    OAK_LEAF(0x323F2A, 0x52623F, 0x708056, 0x98A675),
    BIRCH_LEAF(0x4E5A38, 0x7A8552, 0x9DA670, 0xC4C692),
    FIR_NEEDLE(0x1D2E26, 0x2F4838, 0x48644C, 0x6E8868),
    CYPRESS_LEAF(0x20301F, 0x35492C, 0x50653C, 0x778A55),
    BUSH_LEAF(0x3A4733, 0x5D6C49, 0x808E65, 0xA7B088),
    BLOSSOM(0xC79E95, 0xE6CFC6, 0xF4ECE4),
    GRASS(0x47552B, 0x76833F, 0xA3A45B, 0xCFC48A),
    FERN(0x2C4425, 0x4C6A35, 0x71894A, 0xA0AE68),
    BOULDER(0x6E6A63, 0x969085, 0xB9B2A5, 0xD3CCBE),
    LEDGE(0x84735F, 0xA99880, 0xC8B89D, 0xE0D4BE);

    /** Asset id of the palette. */
    public static final String FILE = "textures/plants.png";

    /** Rows of the palette; the last ones are spare. */
    public static final int ROWS = 16;

    /** The part of the palette's width on each side that has the colour of the end. */
    public static final double MARGIN = 0.06;

    private final int[] darkToLight;

    PlantPaint(int... darkToLight) {
        this.darkToLight = darkToLight;
    }

    /** Returns the texture coordinate across the palette of a shade from 0 (dark) to 1. */
    static double across(double shade) {
        return MARGIN + (1 - 2 * MARGIN) * Math.max(0, Math.min(1, shade));
    }

    /** Returns the texture coordinate of the row's middle, from the bottom edge. */
    double up() {
        return 1 - (ordinal() + 0.5) / ROWS;
    }

    /** Returns the row's colours {@code 0xRRGGBB} from shade 0 to 1 in equal steps. */
    public int[] darkToLight() {
        return darkToLight.clone();
    }
}
