package nephele.engine.level.appearance;

import java.util.ArrayList;
import java.util.List;
import java.util.function.IntBinaryOperator;
import nephele.engine.asset.TestAssets;
import nephele.engine.level.SkyboxLayout;
import org.joml.Vector3d;

/**
 * The direction of each point of a skybox's pictures from formulas of their origin, not from the engine's table:
 * OpenGL's selection of cube faces, and cameras with a heading and a pitch. A colour that is a smooth function of the
 * direction fills the pictures.
 */
public final class SkyboxConvention {
    /** Clockwise from north, upwards, in quarter turns, in the order rt, bk, lf, ft, up, dn. */
    private static final int[][] QUAKE2 = {{1, 0}, {0, 0}, {3, 0}, {2, 0}, {1, 1}, {1, -1}};

    /** Clockwise from north, upwards, in quarter turns, in the order front, right, back, left, up, down. */
    private static final int[][] TERRAGEN = {{0, 0}, {1, 0}, {2, 0}, {3, 0}, {0, 1}, {0, -1}};

    /** The same for +x, −x, +y, −y, +z, −z in the engine's own orientation. */
    private static final int[][] FACES = {{1, 0}, {3, 0}, {0, 1}, {0, -1}, {2, 0}, {0, 0}};

    /** Column and row of +x, −x, +y, −y, +z, −z. */
    private static final int[][] CELLS = {{2, 1}, {0, 1}, {1, 0}, {1, 2}, {3, 1}, {1, 1}};

    private SkyboxConvention() {}

    /** Returns the files' names of a layout with an extension, such as {@code box0.png}. */
    public static List<String> names(SkyboxLayout layout, String extension) {
        List<String> names = new ArrayList<>();
        for (int i = 0; i < (layout == SkyboxLayout.CROSS ? 1 : 6); i++) {
            names.add("box" + i + "." + extension);
        }
        return names;
    }

    /** Returns the layout's files as PNG, filled with {@link #colour}. */
    public static TestAssets assets(SkyboxLayout layout, int side) {
        TestAssets assets = new TestAssets();
        List<String> names = names(layout, "png");
        if (layout == SkyboxLayout.CROSS) {
            return assets.picture(names.get(0), 4 * side, 3 * side, (x, y) -> cross(side, x, y));
        }
        for (int i = 0; i < names.size(); i++) {
            assets.picture(names.get(i), side, side, square(layout, i, side));
        }
        return assets;
    }

    private static int cross(int side, int x, int y) {
        for (int i = 0; i < CELLS.length; i++) {
            if (x / side == CELLS[i][0] && y / side == CELLS[i][1]) {
                return square(SkyboxLayout.FACES, i, side).applyAsInt(x % side, y % side);
            }
        }
        return 0;
    }

    /** Returns 0xrrggbb of the pixels of a layout's picture. */
    public static IntBinaryOperator square(SkyboxLayout layout, int index, int side) {
        return (x, y) -> {
            double right = (2.0 * x + 1) / side - 1;
            double down = (2.0 * y + 1) / side - 1;
            Vector3d colour = colour(direction(layout, index, right, down)).mul(255);
            return (int) Math.round(colour.x) << 16 | (int) Math.round(colour.y) << 8 | (int) Math.round(colour.z);
        };
    }

    /** Returns the stored colour in a direction of any length, 0.1 to 0.9. */
    public static Vector3d colour(Vector3d direction) {
        Vector3d d = new Vector3d(direction).normalize();
        return new Vector3d(
                0.5 + 0.2 * d.x + 0.1 * d.y - 0.1 * d.z,
                0.5 - 0.1 * d.x + 0.2 * d.y + 0.1 * d.z * d.x,
                0.5 + 0.15 * d.x * d.y - 0.2 * d.z);
    }

    /** @return the direction, of any length, of a picture's point −1 to 1 to the right and downwards */
    static Vector3d direction(SkyboxLayout layout, int index, double right, double down) {
        return switch (layout) {
            case OPENGL -> cubeTexture(index, right, down);
            case QUAKE2 -> camera(QUAKE2[index], right, down);
            case TERRAGEN -> camera(TERRAGEN[index], right, down);
            case FACES, CROSS -> camera(FACES[index], right, down);
        };
    }

    /** Solves s_c and t_c of the OpenGL 4.6 core profile, table 8.19, for the direction; t grows with the row. */
    private static Vector3d cubeTexture(int face, double s, double t) {
        return switch (face) {
            case 0 -> new Vector3d(1, -t, -s);
            case 1 -> new Vector3d(-1, -t, s);
            case 2 -> new Vector3d(s, 1, t);
            case 3 -> new Vector3d(s, -1, -t);
            case 4 -> new Vector3d(s, -t, 1);
            default -> new Vector3d(-s, -t, -1);
        };
    }

    /** A camera with a field of view of 90° first pitches, then turns to its heading. */
    private static Vector3d camera(int[] quarters, double right, double down) {
        return new Vector3d(right, -down, -1).rotateX(quarters[1] * Math.PI / 2).rotateY(-quarters[0] * Math.PI / 2);
    }
}
