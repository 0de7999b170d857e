package nephele.engine.scene.impostor;

import java.util.Arrays;
import java.util.concurrent.atomic.AtomicLongArray;
import nephele.engine.asset.Picture;
import nephele.engine.level.Material;
import nephele.engine.level.appearance.ColourDecoding;
import nephele.engine.level.placed.WorldTriangles;
import nephele.engine.math.Vec3;

/** Draws a kind's front faces in one view, with {@value #SAMPLES}² samples a texel. */
final class ViewRaster {
    /** Samples along a side of a texel. */
    static final int SAMPLES = 4;

    private final KindShape shape;
    private final WorldTriangles mesh;
    private final AtlasView view;
    private final int side;
    private final float[] nearest;
    private final int[] seen;
    private final double[] corners;
    private final double[] xs = new double[3];
    private final double[] ys = new double[3];
    private final double[] depths = new double[3];
    /** The triangle of which a sample was added last, for its neighbours mostly show the same; and its normals. */
    private int resolved = -1;

    private final Vec3[] normals = new Vec3[3];

    /** @param texels along a side of the view */
    ViewRaster(KindShape shape, AtlasView view, int texels) {
        this.shape = shape;
        this.view = view;
        mesh = shape.triangles();
        side = SAMPLES * texels;
        corners = projected();
        nearest = new float[side * side];
        seen = new int[side * side];
        Arrays.fill(nearest, Float.NEGATIVE_INFINITY);
        Arrays.fill(seen, -1);
        for (int triangle = 0; triangle < mesh.count(); triangle++) {
            if (mesh.faceNormal(triangle).dot(view.towards()) > 0) {
                draw(triangle);
            }
        }
    }

    /** Returns x and y in samples and depth in radii of every corner. */
    private double[] projected() {
        double half = side / 2.0;
        double across = half * ImpostorAtlas.FILLED / shape.halfWidth();
        double along = half * ImpostorAtlas.FILLED / view.halfHeight();
        double[] all = new double[9 * mesh.count()];
        for (int i = 0; i < 3 * mesh.count(); i++) {
            Vec3 p = mesh.corner(i / 3, i % 3).minus(shape.centre());
            all[3 * i] = half + across * p.dot(view.right());
            all[3 * i + 1] = half + along * p.dot(view.up());
            all[3 * i + 2] = p.dot(view.towards()) / shape.radius();
        }
        return all;
    }

    private void take(int triangle) {
        for (int corner = 0; corner < 3; corner++) {
            xs[corner] = corners[9 * triangle + 3 * corner];
            ys[corner] = corners[9 * triangle + 3 * corner + 1];
            depths[corner] = corners[9 * triangle + 3 * corner + 2];
        }
    }

    private double area() {
        return (xs[1] - xs[0]) * (ys[2] - ys[0]) - (xs[2] - xs[0]) * (ys[1] - ys[0]);
    }

    private void draw(int triangle) {
        take(triangle);
        double area = area();
        if (Math.abs(area) < 1e-12) {
            return;
        }
        int left = first(Math.min(xs[0], Math.min(xs[1], xs[2])));
        int right = last(Math.max(xs[0], Math.max(xs[1], xs[2])));
        int bottom = first(Math.min(ys[0], Math.min(ys[1], ys[2])));
        int top = last(Math.max(ys[0], Math.max(ys[1], ys[2])));
        for (int y = bottom; y <= top; y++) {
            // Weights as weight() has them, of which all but one product is the same along a row.
            double rowA = (xs[2] - xs[1]) * (y + 0.5 - ys[1]);
            double rowB = (xs[0] - xs[2]) * (y + 0.5 - ys[2]);
            drawRow(triangle, y, left, right, area, rowA, rowB);
        }
    }

    private void drawRow(int triangle, int y, int left, int right, double area, double rowA, double rowB) {
        double slopeA = ys[2] - ys[1];
        double slopeB = ys[0] - ys[2];
        double firstX = xs[1];
        double secondX = xs[2];
        boolean isInside = false;
        for (int x = left; x <= right; x++) {
            double a = (rowA - slopeA * (x + 0.5 - firstX)) / area;
            double b = (rowB - slopeB * (x + 0.5 - secondX)) / area;
            double c = 1 - a - b;
            if (a >= 0 && b >= 0 && c >= 0) {
                float depth = (float) (a * depths[0] + b * depths[1] + c * depths[2]);
                int at = y * side + x;
                if (depth > nearest[at]) {
                    nearest[at] = depth;
                    seen[at] = triangle;
                }
                isInside = true;
            } else if (isInside && (a < 0 || b < 0)) {
                return;
            }
        }
    }

    private int first(double least) {
        return Math.max(0, (int) Math.ceil(least - 0.5));
    }

    private int last(double most) {
        return Math.min(side - 1, (int) Math.floor(most - 0.5));
    }

    private double weight(int from, int to, double x, double y) {
        return (xs[to] - xs[from]) * (y - ys[from]) - (ys[to] - ys[from]) * (x - xs[from]);
    }

    /** Adds up the samples of each texel into an atlas. @param atlas as {@link AtlasImage#values} has it */
    void resolve(Albedo albedo, AtlasImage atlas, int left, int bottom) {
        int texels = side / SAMPLES;
        float[] sum = new float[AtlasImage.CHANNELS];
        for (int y = 0; y < texels; y++) {
            for (int x = 0; x < texels; x++) {
                Arrays.fill(sum, 0);
                int count = 0;
                for (int i = 0; i < SAMPLES * SAMPLES; i++) {
                    int column = SAMPLES * x + i % SAMPLES;
                    int row = SAMPLES * y + i / SAMPLES;
                    if (seen[row * side + column] >= 0) {
                        add(column, row, albedo, sum);
                        count++;
                    }
                }
                atlas.put(left + x, bottom + y, sum, count, SAMPLES * SAMPLES);
            }
        }
    }

    /** Adds the number of samples that show each triangle. */
    void countInto(AtomicLongArray counts) {
        for (int triangle : seen) {
            if (triangle >= 0) {
                counts.incrementAndGet(triangle);
            }
        }
    }

    private void add(int column, int row, Albedo albedo, float[] sum) {
        int at = row * side + column;
        int triangle = seen[at];
        if (triangle != resolved) {
            resolved = triangle;
            take(triangle);
            for (int corner = 0; corner < 3; corner++) {
                normals[corner] = mesh.normal(triangle, corner);
            }
        }
        double area = area();
        double a = weight(1, 2, column + 0.5, row + 0.5) / area;
        double b = weight(2, 0, column + 0.5, row + 0.5) / area;
        double c = 1 - a - b;
        albedo.add(
                a * mesh.s(triangle, 0) + b * mesh.s(triangle, 1) + c * mesh.s(triangle, 2),
                a * mesh.t(triangle, 0) + b * mesh.t(triangle, 1) + c * mesh.t(triangle, 2),
                sum);
        Vec3 n = normals[0].scaled(a).addScaled(b, normals[1]).addScaled(c, normals[2]);
        double length = Math.max(n.length(), 1e-9);
        sum[4] += n.x() / length;
        sum[5] += n.y() / length;
        sum[6] += n.z() / length;
        sum[7] += nearest[at];
    }

    /** The colour of a material's surface, with the light that a lobe would reflect: impostors are matt. */
    public static final class Albedo {
        private final Vec3 base;
        private final double lobe;
        /** {@code null} without a texture. */
        private final Picture picture;

        private final double[] linear;

        /** @param picture 8-bit RGBA; {@code null} without a texture */
        Albedo(Material material, Picture picture, ColourDecoding decoding) {
            this.picture = picture;
            base = material.baseColour();
            lobe = ImpostorAtlas.lobe(material);
            linear = decoding.table();
        }

        /** Adds the linear colour at texture coordinates. @param t 0 at the picture's top row */
        void add(double s, double t, float[] sum) {
            double red = base.x();
            double green = base.y();
            double blue = base.z();
            if (picture != null) {
                int x = (int) ((s - Math.floor(s)) * picture.width()) % picture.width();
                int y = (int) ((t - Math.floor(t)) * picture.height()) % picture.height();
                red *= linear[picture.sample(x, y, 0)];
                green *= linear[picture.sample(x, y, 1)];
                blue *= linear[picture.sample(x, y, 2)];
            }
            sum[0] += red + (1 - red) * lobe;
            sum[1] += green + (1 - green) * lobe;
            sum[2] += blue + (1 - blue) * lobe;
        }
    }
}
