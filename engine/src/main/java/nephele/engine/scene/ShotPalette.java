package nephele.engine.scene;

import nephele.engine.math.Vec3;

/**
 * The colours of the two shots' portals, linear RGB as displayed. In each palette the two differ in lightness as well, and
 * their patterns differ in every palette, so that they can be distinguished without colour vision.
 */
public enum ShotPalette {
    BLUE_ORANGE(new Vec3(0.05, 0.42, 1), new Vec3(1, 0.36, 0.03), 0x4db4ff, 0xffa53d),
    /** For protanopia and deuteranopia: nothing depends on red against green. */
    BLUE_YELLOW(new Vec3(0.02, 0.17, 0.85), new Vec3(1, 0.8, 0.06), 0x5c8dff, 0xffe95c),
    /** For tritanopia: nothing depends on blue against yellow. */
    CYAN_RED(new Vec3(0.16, 0.8, 0.85), new Vec3(0.75, 0.015, 0.04), 0x8ff2f6, 0xff5a66),
    WHITE_MAGENTA(new Vec3(0.95, 0.95, 0.95), new Vec3(0.7, 0.005, 0.6), 0xffffff, 0xff66ee);

    private final Vec3 first;
    private final Vec3 second;
    private final int firstLight;
    private final int secondLight;

    ShotPalette(Vec3 first, Vec3 second, int firstLight, int secondLight) {
        this.first = first;
        this.second = second;
        this.firstLight = firstLight;
        this.secondLight = secondLight;
    }

    /**
     * Returns the colour of a shot's rim.
     *
     * @param shot 0 or 1
     */
    public Vec3 rim(int shot) {
        return shot == 0 ? first : second;
    }

    /**
     * Returns the lighter colour of a shot in an overlay, sRGB as {@code 0xRRGGBB}.
     *
     * @param shot 0 or 1
     */
    public int overlay(int shot) {
        return shot == 0 ? firstLight : secondLight;
    }
}
