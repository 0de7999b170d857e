package nephele.workshop.art.picture;

import java.awt.image.BufferedImage;
import nephele.workshop.art.paint.ColourRamp;
import nephele.workshop.art.paint.PaintColour;
import nephele.workshop.art.paint.Pixels;
import nephele.workshop.art.paint.Shapes;
import nephele.workshop.art.paint.SphereNoise;
import nephele.workshop.art.paint.TileNoise;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/** Painters of the sun, and of planets that show only their atmosphere: bands, sheared by winds, and storms. */
final class CloudyGlobes {
    private static final int RING_SIDE = 256;
    private static final ColourRamp ICE = ColourRamp.of(0x4A4136, 0x7D6F5B, 0xA8977B, 0xCDBD9C, 0xE7DAbF);

    private CloudyGlobes() {}

    /** Paints a star: granules of rising gas, bright veins around them and a few groups of spots. */
    static Globe.Brush sun() {
        ColourRamp fire = ColourRamp.of(0x8A2A06, 0xC64A0A, 0xEB7B14, 0xF9A828, 0xFFCB4E, 0xFFE58A, 0xFFF6CF);
        SphereNoise gas = new SphereNoise(907);
        return p -> {
            double flow = gas.cloud(gas.warped(p, 3, 4, 0.25), 2.4, 5);
            double grains = gas.ridges(gas.warped(p, 6, 2, 0.06), 13, 2);
            double belt = 1 - Shapes.ramp(0.25, 0.55, Math.abs(p.y()));
            double spots = belt * Shapes.ramp(0.5, 0.66, gas.cloud(p, 4.2, 3) + 0.1 * grains);
            return fire.at(0.6 + 0.26 * flow + 0.22 * (grains - 0.45)).mix(fire.at(0.05), 0.85 * spots);
        };
    }

    static Globe.Brush venus() {
        ColourRamp clouds = ColourRamp.of(0xA9783F, 0xCFA263, 0xE6C890, 0xF1DFB8, 0xF8EED6);
        SphereNoise noise = new SphereNoise(801);
        return p -> {
            Vector3d swept = noise.warped(new Vector3d(p.x(), 2.2 * p.y() + 0.5 * (p.x() * p.x()), p.z()), 1.4, 5, 0.5);
            return clouds.at(0.55 + 0.55 * noise.cloud(swept, 1.3, 6));
        };
    }

    static Globe.Brush jupiter() {
        ColourRamp bands = ColourRamp.of(
                0x7C6A5C, 0x9B8673, 0xC7B299, 0xA97B55, 0xE8DCC6, 0xF3EADA, 0xB5744A, 0x8F5638, 0xD9B48C, 0xF5EEE0,
                0xF2E4CB, 0xB87B52, 0x95603F, 0xE4CFAF, 0xC9AF93, 0xA98C73, 0x8A7868, 0x74665C);
        SphereNoise noise = new SphereNoise(809);
        Vector3d spot = Globe.direction(205, -22);
        return p -> {
            double storm = storm(p, spot, 0.36, 0.18);
            double shear = shear(noise, p, 0.065) * (1 - 0.7 * storm);
            double latitude = 0.5 + StrictMath.asin(Math.max(-1, Math.min(1, p.y()))) / Math.PI;
            double around = 0.02 * Shapes.ramp(0, 0.6, storm) * (p.y() < spot.y ? -1 : 1);
            PaintColour air = bands.at(latitude + shear + around);
            PaintColour curls = air.times(1 + 0.13 * noise.cloud(noise.warped(sheared(p, 4), 3, 3, 0.3), 4, 4));
            PaintColour red = PaintColour.of(0xB4532F).mix(PaintColour.of(0xE0A078), 0.5 + 0.5 * noise.cloud(p, 12, 3));
            PaintColour collar = curls.mix(PaintColour.of(0xF4E9D8), 0.7 * Shapes.ramp(0.05, 0.3, storm));
            return collar.mix(red, Shapes.ramp(0.3, 0.5, storm));
        };
    }

    static Globe.Brush saturn() {
        ColourRamp bands = ColourRamp.of(
                0x9C8A66, 0xB7A278, 0xCDB78A, 0xD9C79B, 0xC8AE7C, 0xE5D5AC, 0xEFE2BE, 0xE2CD9C, 0xF2E7C8, 0xE6D3A6,
                0xD8BF8C, 0xE0CC9E, 0xC9B283, 0xB9A57C, 0xA6977A);
        SphereNoise noise = new SphereNoise(821);
        return p -> {
            double latitude = 0.5 + StrictMath.asin(Math.max(-1, Math.min(1, p.y()))) / Math.PI;
            return bands.at(latitude + shear(noise, p, 0.012)).times(1 + 0.025 * noise.cloud(sheared(p, 6), 4, 3));
        };
    }

    static Globe.Brush uranus() {
        ColourRamp air = ColourRamp.of(0x7FBAC4, 0x9AD0D4, 0xB4E1E0, 0xC9ECE8, 0xDDF4EF);
        SphereNoise noise = new SphereNoise(823);
        return p -> air.at(0.45 + 0.4 * p.y() + shear(noise, p, 0.05) + 0.04 * noise.cloud(sheared(p, 5), 3, 3));
    }

    static Globe.Brush neptune() {
        ColourRamp air = ColourRamp.of(0x1B2F7A, 0x2647A6, 0x3566C9, 0x4B86DF, 0x77AEEC);
        SphereNoise noise = new SphereNoise(827);
        Vector3d spot = Globe.direction(150, -20);
        PaintColour wisp = PaintColour.of(0xE8F2FC);
        return p -> {
            double storm = storm(p, spot, 0.28, 0.15);
            double band = 0.5 * noise.smooth(0.3, 5.5 * p.y(), 0.7) + 0.25 * noise.smooth(8.1, 13 * p.y(), 2.2);
            PaintColour blue =
                    air.at(0.5 + 0.5 * band + 2 * shear(noise, p, 0.05)).mix(air.at(0), Shapes.ramp(0.3, 0.6, storm));
            double streak = noise.cloud(sheared(noise.warped(p, 2, 2, 0.1), 9), 1.6, 4);
            double rim =
                    Shapes.ramp(0.02, 0.2, storm) * (1 - Shapes.ramp(0.2, 0.35, storm)) * (p.y() < spot.y ? 1 : 0.2);
            return blue.mix(wisp, 0.8 * Shapes.ramp(0.42, 0.8, streak)).mix(wisp, 0.5 * rim);
        };
    }

    /** Scales the latitude coordinate, so that noise is stretched along the parallels. */
    private static Vector3d sheared(Vector3dc p, double times) {
        return new Vector3d(p.x(), times * p.y(), p.z());
    }

    /** Returns the displacement of a band's edge by winds, as a fraction of the height from pole to pole. */
    private static double shear(SphereNoise noise, Vector3dc p, double most) {
        Vector3d curled = noise.warped(sheared(p, 2.5), 3, 4, 0.22);
        double meander = noise.cloud(new Vector3d(2.6 * p.x(), 9 * p.y(), 2.6 * p.z()), 1, 2);
        return most * (0.45 * meander + 0.55 * noise.cloud(curled, 3.4, 5)) * (1 - p.y() * p.y());
    }

    /** Returns the weight of an oval storm: 1 in its middle, 0 on its edge and outside. */
    private static double storm(Vector3dc p, Vector3d centre, double halfWidth, double halfHeight) {
        if (p.dot(centre) < 0.5) {
            return 0;
        }
        Vector3d east = new Vector3d(centre.z, 0, -centre.x).normalize();
        double x = p.dot(east) / halfWidth;
        double y = (p.y() - centre.y) / halfHeight;
        return Math.max(0, 1 - Math.sqrt(x * x + y * y));
    }

    /**
     * Painter of Saturn's rings for a flattened torus. The picture goes once around the planet to the right and once around
     * the tube upwards, so that the rows run outwards from the planet and back.
     */
    static BufferedImage saturnRings() {
        SphereNoise noise = new SphereNoise(877);
        TileNoise clumps = new TileNoise(881);
        return Pixels.picture(RING_SIDE, RING_SIDE, (column, row) -> {
            double turn = 1 - (row + 0.5) / RING_SIDE;
            double out = 0.5 - 0.5 * StrictMath.cos(2 * Math.PI * turn);
            double grooves = 0.5 * noise.smooth(5 * out, 0.3, 0.1)
                    + 0.35 * noise.smooth(17 * out, 4.3, 0.1)
                    + 0.3 * noise.smooth(47 * out, 8.3, 0.1);
            double grain = 0.03 * clumps.stretched((column + 0.5) / RING_SIDE, turn, 8, 48, 2);
            return ICE.at(0.66 + 0.5 * grooves + grain).rgb();
        });
    }
}
