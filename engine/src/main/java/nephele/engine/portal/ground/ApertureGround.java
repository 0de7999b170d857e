package nephele.engine.portal.ground;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;
import nephele.engine.math.heightfield.HeightField;
import nephele.engine.math.heightfield.HeightFieldSurface;
import nephele.engine.portal.Aperture;
import nephele.engine.portal.Portal;

/**
 * The ground under an aperture and a rim around it: the triangles of a terrain, clipped along the portal's normal.
 * Heights above a plane are linear on each, so their extremes are at the corners kept here, in the portal's axes.
 */
final class ApertureGround {
    /** Width of the rim around the aperture; the drawn rim is as wide. */
    static final double RIM_METRES = 0.1;

    /** Ground that is wholly farther than this from the portal's plane is another slope. */
    private static final double FAR_METRES = 0.25;

    private static final int SAMPLE_COLUMNS = 4;
    private static final int SAMPLE_ROWS = 6;

    private final Portal portal;
    private final Aperture aperture;
    /** For each corner: across, upward, in front. */
    private double[] corners = new double[3 * 64];

    private int count;
    private double[] piece = new double[3 * (Aperture.MOST_CORNERS + 4)];
    private double[] clipped = new double[3 * (Aperture.MOST_CORNERS + 4)];

    private ApertureGround(Portal portal) {
        this.portal = portal;
        aperture = portal.aperture();
    }

    static ApertureGround under(HeightField field, Portal portal) {
        ApertureGround ground = new ApertureGround(portal);
        Aabb box = ground.box();
        List<Integer> triangles = new ArrayList<>();
        field.passing(box::overlaps, triangles::add);
        triangles.sort(null);
        for (int triangle : triangles) {
            ground.add(field, triangle);
        }
        return ground;
    }

    /** Returns a few points of the ground well inside an aperture. */
    static ApertureGround sampled(HeightField field, Portal portal) {
        ApertureGround ground = new ApertureGround(portal);
        for (int row = 0; row < SAMPLE_ROWS; row++) {
            for (int column = 0; column < SAMPLE_COLUMNS; column++) {
                ground.sample(field, (column + 0.5) / SAMPLE_COLUMNS - 0.5, (row + 0.5) / SAMPLE_ROWS - 0.5);
            }
        }
        return ground;
    }

    /** Adds the ground above or below a point of the plane, given in widths and heights of the aperture. */
    private void sample(HeightField field, double across, double upward) {
        Vec3 on = portal.world(across * aperture.widthMetres(), upward * aperture.heightMetres(), 0);
        double y = HeightFieldSurface.y(field, on.x(), on.z());
        double x = portal.across(on.x(), y, on.z());
        double up = portal.upward(on.x(), y, on.z());
        if (aperture.outside(x, up) <= 0) {
            corners[3 * count] = x;
            corners[3 * count + 1] = up;
            corners[3 * count + 2] = portal.inFront(on.x(), y, on.z());
            count++;
        }
    }

    private Aabb box() {
        double x = aperture.widthMetres() / 2 + 2 * RIM_METRES;
        double y = aperture.heightMetres() / 2 + 2 * RIM_METRES;
        List<Vec3> ends = new ArrayList<>();
        for (int i = 0; i < 8; i++) {
            ends.add(portal.world(
                    (i & 1) == 0 ? x : -x, (i & 2) == 0 ? y : -y, (i & 4) == 0 ? FAR_METRES : -FAR_METRES));
        }
        return Aabb.of(ends);
    }

    private void add(HeightField field, int triangle) {
        boolean isInside = true;
        for (int corner = 0; corner < 3; corner++) {
            Vec3 p = field.corner(triangle, corner);
            piece[3 * corner] = portal.across(p.x(), p.y(), p.z());
            piece[3 * corner + 1] = portal.upward(p.x(), p.y(), p.z());
            piece[3 * corner + 2] = portal.inFront(p.x(), p.y(), p.z());
            isInside &= aperture.outside(piece[3 * corner], piece[3 * corner + 1]) <= RIM_METRES;
        }
        int left = isInside ? 3 : clip(3);
        if (left > 0 && isNear(left)) {
            if (3 * (count + left) > corners.length) {
                corners = Arrays.copyOf(corners, 2 * corners.length + 3 * left);
            }
            System.arraycopy(piece, 0, corners, 3 * count, 3 * left);
            count += left;
        }
    }

    /** Clips the piece at the aperture's edges, moved outwards by the rim (Sutherland and Hodgman 1974). */
    private int clip(int before) {
        int size = before;
        for (int edge = 0; edge < aperture.corners() && size > 0; edge++) {
            int kept = 0;
            for (int i = 0; i < size; i++) {
                int next = (i + 1) % size;
                double here = beyond(edge, i);
                double there = beyond(edge, next);
                if (here <= 0) {
                    System.arraycopy(piece, 3 * i, clipped, 3 * kept++, 3);
                }
                if (here < 0 && there > 0 || here > 0 && there < 0) {
                    double share = here / (here - there);
                    for (int axis = 0; axis < 3; axis++) {
                        double from = piece[3 * i + axis];
                        clipped[3 * kept + axis] = from + share * (piece[3 * next + axis] - from);
                    }
                    kept++;
                }
            }
            double[] swapped = piece;
            piece = clipped;
            clipped = swapped;
            size = kept;
        }
        return size;
    }

    private double beyond(int edge, int corner) {
        return aperture.edgeNormalX(edge) * piece[3 * corner]
                + aperture.edgeNormalY(edge) * piece[3 * corner + 1]
                - aperture.edgeDistance(edge)
                - RIM_METRES;
    }

    private boolean isNear(int size) {
        double least = Double.POSITIVE_INFINITY;
        double greatest = Double.NEGATIVE_INFINITY;
        for (int i = 0; i < size; i++) {
            least = Math.min(least, piece[3 * i + 2]);
            greatest = Math.max(greatest, piece[3 * i + 2]);
        }
        return least <= FAR_METRES && greatest >= -FAR_METRES;
    }

    int size() {
        return count;
    }

    double across(int corner) {
        return corners[3 * corner];
    }

    double upward(int corner) {
        return corners[3 * corner + 1];
    }

    double inFront(int corner) {
        return corners[3 * corner + 2];
    }

    /** Returns the height in front of the portal's plane of the ground's lowest part; infinity for none. */
    double lowest() {
        double least = Double.POSITIVE_INFINITY;
        for (int i = 0; i < count; i++) {
            least = Math.min(least, inFront(i));
        }
        return least;
    }

    /** Returns the height in front of the portal's plane of the ground's highest part; −infinity for none. */
    double highest() {
        double greatest = Double.NEGATIVE_INFINITY;
        for (int i = 0; i < count; i++) {
            greatest = Math.max(greatest, inFront(i));
        }
        return greatest;
    }
}
