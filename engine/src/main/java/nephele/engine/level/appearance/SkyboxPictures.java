package nephele.engine.level.appearance;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;
import nephele.engine.asset.AssetException;
import nephele.engine.asset.Picture;
import nephele.engine.asset.PictureDecoder;
import nephele.engine.level.Sky;
import nephele.engine.level.SkyboxLayout;
import org.joml.Vector3d;

/**
 * The six squares of a skybox as 8-bit RGBA in the order and orientation of {@link SkyboxLayout#FACES}, whatever the
 * layout of the files is: +x −x +y −y +z −z, each as seen from the centre, sides with world up upwards, +y with its
 * bottom edge and −y with its top edge at −z.
 *
 * @param side pixels along each edge
 */
public record SkyboxPictures(int side, List<Picture> pictures) {
    /** Column and row of +x −x +y −y +z −z in a cross. */
    private static final int[][] CROSS_CELLS = {{2, 1}, {0, 1}, {1, 0}, {1, 2}, {3, 1}, {1, 1}};

    private static final int BYTES = 4;

    /** A point of the cube: a face, and coordinates on it, −1 to 1. */
    private record CubePoint(int face, double right, double up) {
        static CubePoint of(double x, double y, double z) {
            double ax = Math.abs(x);
            double ay = Math.abs(y);
            double az = Math.abs(z);
            if (ax >= ay && ax >= az) {
                return x > 0 ? new CubePoint(0, z / ax, y / ax) : new CubePoint(1, -z / ax, y / ax);
            }
            if (ay >= az) {
                return y > 0 ? new CubePoint(2, x / ay, z / ay) : new CubePoint(3, x / ay, -z / ay);
            }
            return z > 0 ? new CubePoint(4, -x / az, y / az) : new CubePoint(5, x / az, y / az);
        }

        /** Returns the same point on the face that contains it: one step beyond an edge is on the adjacent face. */
        CubePoint folded() {
            return switch (face) {
                case 0 -> of(1, up, right);
                case 1 -> of(-1, up, -right);
                case 2 -> of(right, 1, up);
                case 3 -> of(right, -1, -up);
                case 4 -> of(-right, up, 1);
                default -> of(right, up, -1);
            };
        }
    }

    /**
     * Reads the files of a sky.
     *
     * @param pictureOf decodes an asset
     * @throws IllegalArgumentException for a number of files that its layout does not have, which a level that no rule
     *     has checked can name
     */
    public static SkyboxPictures of(Sky.Skybox sky, Function<String, Picture> pictureOf) {
        int wanted = SkyboxSquare.files(sky.layout());
        if (sky.files().size() != wanted) {
            throw new IllegalArgumentException("a skybox of this layout has " + wanted + " files, not "
                    + sky.files().size());
        }
        return PictureDecoder.inMemory(sky.files().get(0), () -> read(sky, pictureOf));
    }

    private static SkyboxPictures read(Sky.Skybox sky, Function<String, Picture> pictureOf) {
        List<Picture> read = sky.layout() == SkyboxLayout.CROSS
                ? cells(sky.files().get(0), pictureOf)
                : squares(sky.files(), pictureOf);
        List<SkyboxSquare> squares = SkyboxSquare.of(sky.layout());
        List<Picture> pictures = SkyboxSquare.of(SkyboxLayout.FACES).stream()
                .map(face -> turned(read, squares, face))
                .toList();
        return new SkyboxPictures(read.get(0).width(), pictures);
    }

    private static List<Picture> squares(List<String> files, Function<String, Picture> pictureOf) {
        List<Picture> pictures = new ArrayList<>();
        for (String file : files) {
            Picture picture = pictureOf.apply(file).toRgba8();
            int side = pictures.isEmpty() ? picture.width() : pictures.get(0).width();
            requireFace(file, picture.width(), picture.height(), side);
            pictures.add(picture);
        }
        return pictures;
    }

    private static List<Picture> cells(String file, Function<String, Picture> pictureOf) {
        Picture whole = pictureOf.apply(file).toRgba8();
        int side = crossSide(file, whole.width(), whole.height());
        List<Picture> pictures = new ArrayList<>();
        for (int[] cell : CROSS_CELLS) {
            pictures.add(cut(whole, cell[0] * side, cell[1] * side, side));
        }
        return pictures;
    }

    private static Picture cut(Picture whole, int left, int top, int side) {
        byte[] samples = new byte[BYTES * side * side];
        for (int y = 0; y < side; y++) {
            int from = BYTES * ((top + y) * whole.width() + left);
            System.arraycopy(whole.samples(), from, samples, BYTES * y * side, BYTES * side);
        }
        return new Picture(side, side, BYTES, 8, samples);
    }

    /** Returns the picture on the side of {@code face}, rotated or mirrored to its axes. */
    private static Picture turned(List<Picture> read, List<SkyboxSquare> squares, SkyboxSquare face) {
        int from = 0;
        while (!squares.get(from).outward().equals(face.outward())) {
            from++;
        }
        SkyboxSquare as = squares.get(from);
        Picture picture = read.get(from);
        boolean isTurned = !as.right().equals(face.right()) || !as.down().equals(face.down());
        return isTurned ? turned(picture, as, face) : picture;
    }

    private static Picture turned(Picture picture, SkyboxSquare as, SkyboxSquare face) {
        int side = picture.width();
        int step = BYTES * (as.right().dot(face.right()) + as.down().dot(face.right()) * side);
        int rowStep = BYTES * (as.right().dot(face.down()) + as.down().dot(face.down()) * side);
        int first = (step < 0 ? -step * (side - 1) : 0) + (rowStep < 0 ? -rowStep * (side - 1) : 0);
        byte[] samples = new byte[picture.samples().length];
        int to = 0;
        for (int y = 0; y < side; y++) {
            int from = first + y * rowStep;
            for (int x = 0; x < side; x++, from += step, to += BYTES) {
                System.arraycopy(picture.samples(), from, samples, to, BYTES);
            }
        }
        return new Picture(side, side, BYTES, 8, samples);
    }

    /**
     * Requires a square face.
     *
     * @param side side of the first face
     */
    public static void requireFace(String file, int width, int height, int side) {
        if (width != side || height != side) {
            throw new AssetException(
                    file,
                    "is " + width + " x " + height + " pixels",
                    "the six faces of a skybox must be squares of one size, here " + side);
        }
    }

    /** Returns the side of each face in a cross of four columns and three rows. */
    public static int crossSide(String file, int width, int height) {
        int side = width / 4;
        if (side == 0 || width != 4 * side || height != 3 * side) {
            throw new AssetException(
                    file,
                    "is " + width + " x " + height + " pixels",
                    "a skybox cross has four columns and three rows of squares");
        }
        return side;
    }

    /**
     * Returns the linear radiance in a direction, interpolated between the four nearest pixels, also across the cube's
     * edges.
     *
     * @param linear the radiance of each code
     */
    Vector3d radiance(double[] linear, double x, double y, double z) {
        CubePoint at = CubePoint.of(x, y, z);
        double column = (at.right() + 1) / 2 * side - 0.5;
        double row = (1 - at.up()) / 2 * side - 0.5;
        int left = (int) Math.floor(column);
        int top = (int) Math.floor(row);
        double fx = column - left;
        double fy = row - top;
        Vector3d sum = new Vector3d();
        addPixel(linear, sum, at.face(), left, top, (1 - fx) * (1 - fy));
        addPixel(linear, sum, at.face(), left + 1, top, fx * (1 - fy));
        addPixel(linear, sum, at.face(), left, top + 1, (1 - fx) * fy);
        addPixel(linear, sum, at.face(), left + 1, top + 1, fx * fy);
        return sum;
    }

    /** A pixel beyond one edge is the adjacent face's; beyond a corner there is none, and the three around it count. */
    private void addPixel(double[] linear, Vector3d sum, int face, int column, int row, double weight) {
        int onColumn = clamped(column);
        int onRow = clamped(row);
        if (column != onColumn && row != onRow) {
            addPixel(linear, sum, face, onColumn, onRow, weight / 3);
            addPixel(linear, sum, face, column, onRow, weight / 3);
            addPixel(linear, sum, face, onColumn, row, weight / 3);
            return;
        }
        CubePoint middle = new CubePoint(face, (2.0 * column + 1) / side - 1, 1 - (2.0 * row + 1) / side);
        CubePoint place = column == onColumn && row == onRow ? middle : middle.folded();
        Picture picture = pictures.get(place.face());
        int x = index(place.right());
        int y = index(-place.up());
        sum.add(
                weight * linear[picture.sample(x, y, 0)],
                weight * linear[picture.sample(x, y, 1)],
                weight * linear[picture.sample(x, y, 2)]);
    }

    private int index(double s) {
        return clamped((int) ((s + 1) / 2 * side));
    }

    private int clamped(int pixel) {
        return Math.min(Math.max(pixel, 0), side - 1);
    }
}
