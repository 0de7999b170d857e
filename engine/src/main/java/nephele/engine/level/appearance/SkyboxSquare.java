package nephele.engine.level.appearance;

import java.util.List;
import nephele.engine.level.BoxFace;
import nephele.engine.level.SkyboxLayout;
import nephele.engine.math.Basis;
import nephele.engine.math.Vec3;

/**
 * One of the six squares of a skybox, in world axes: y up, −z north.
 *
 * @param name the usual end of its file's name
 * @param outward the axis through its middle
 * @param right the direction of its picture's right
 * @param down the direction of its picture's lower edge
 */
public record SkyboxSquare(String name, BoxFace outward, BoxFace right, BoxFace down) {
    /**
     * The squares in the order +x −x +y −y +z −z as seen from the centre. Sides have up at their top edge; +y has −z at
     * its bottom edge, −y at its top edge.
     */
    private static final List<SkyboxSquare> FACES =
            squares("px +x +z -y", "nx -x -z -y", "py +y +x -z", "ny -y +x +z", "pz +z -x -y", "nz -z +x -y");

    /**
     * The squares of a cube texture, as glTexImage2D takes them, first row on top (OpenGL 4.6 core profile,
     * section 8.13, table 8.19): seen from the centre, each is mirrored.
     */
    private static final List<SkyboxSquare> OPENGL =
            squares("px +x -z -y", "nx -x +z -y", "py +y +x +z", "ny -y +x -z", "pz +z +x -y", "nz -z -x -y");

    /**
     * The squares in the order of the suffixes in Quake II's renderer (id Software 2001, gl_warp.c: {@code suf},
     * {@code st_to_vec}). Its x, y and z, east, north and up on its maps, are our x, −z and y.
     */
    private static final List<SkyboxSquare> QUAKE2 =
            squares("rt +x +z -y", "bk -z +x -y", "lf -x -z -y", "ft +z -x -y", "up +y +z +x", "dn -y +z -x");

    /** What a Terragen camera of zoom 1 renders at headings 0°, 90°, 180°, 270°, and pitches ±90° at heading 0°. */
    private static final List<SkyboxSquare> TERRAGEN = squares(
            "front -z +x -y", "right +x +z -y", "back +z -x -y", "left -x -z -y", "up +y +x -z", "down -y +x +z");

    /**
     * Returns the direction of a point of the picture, not of unit length.
     *
     * @param s −1 at the left edge, 1 at the right one
     * @param t −1 at the upper edge, 1 at the lower one
     */
    public Vec3 direction(double s, double t) {
        return outward.normal().addScaled(s, right.normal()).addScaled(t, down.normal());
    }

    /** Returns the frame that looks at the picture. */
    public Basis basis() {
        Vec3 middle = direction(0, 0);
        return new Basis(direction(1, 0).minus(middle), middle.minus(direction(0, 1)), middle.scaled(-1));
    }

    /** Returns the six squares of a layout: in the order of its files, or of +x −x +y −y +z −z for a cross. */
    public static List<SkyboxSquare> of(SkyboxLayout layout) {
        return switch (layout) {
            case FACES, CROSS -> FACES;
            case OPENGL -> OPENGL;
            case QUAKE2 -> QUAKE2;
            case TERRAGEN -> TERRAGEN;
        };
    }

    /** Returns the number of files of a layout. */
    public static int files(SkyboxLayout layout) {
        return layout == SkyboxLayout.CROSS ? 1 : of(layout).size();
    }

    private static List<SkyboxSquare> squares(String... lines) {
        return List.of(lines).stream().map(SkyboxSquare::square).toList();
    }

    private static SkyboxSquare square(String line) {
        String[] words = line.split(" ");
        return new SkyboxSquare(words[0], BoxFace.of(words[1]), BoxFace.of(words[2]), BoxFace.of(words[3]));
    }
}
