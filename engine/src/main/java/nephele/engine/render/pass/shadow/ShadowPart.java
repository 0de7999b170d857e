package nephele.engine.render.pass.shadow;

import java.util.List;
import java.util.Optional;
import nephele.engine.math.Frustum;
import nephele.engine.math.Vec3;
import nephele.engine.math.heightfield.HeightField;
import nephele.engine.math.heightfield.SampleRange;
import nephele.engine.render.gl.Texture;
import nephele.engine.scene.light.ShadowFrame;
import org.joml.Matrix4d;
import org.joml.Vector3d;

/**
 * The part of a sun's depth map that heights have changed.
 *
 * @param within what can be seen in the part
 */
record ShadowPart(Texture.Region texels, Frustum within) {
    /** Rounding and the rasteriser's rules move an edge by less. */
    private static final int MARGIN_TEXELS = 2;

    /** Returns the part between two versions of all terrains; empty if the whole map has to be drawn. */
    static Optional<ShadowPart> changed(ShadowFrame frame, List<HeightField> before, List<HeightField> after) {
        if (before.size() != after.size()) {
            return Optional.empty();
        }
        double[] ends = {1, 1, 0, 0};
        for (int i = 0; i < after.size(); i++) {
            Optional<SampleRange> range =
                    after.get(i).origin().equals(before.get(i).origin())
                            ? after.get(i).difference(before.get(i))
                            : Optional.empty();
            if (range.isEmpty()) {
                return Optional.empty();
            }
            if (!range.get().isEmpty()) {
                add(frame, before.get(i), range.get(), ends);
                add(frame, after.get(i), range.get(), ends);
            }
        }
        return Optional.of(of(frame, ends));
    }

    /** Widens the ends, in shares of the map, by the samples and those around them. */
    private static void add(ShadowFrame frame, HeightField field, SampleRange range, double[] ends) {
        int lastColumn = Math.min(range.lastColumn() + 1, field.cellColumns());
        int lastRow = Math.min(range.lastRow() + 1, field.cellRows());
        for (int row = Math.max(0, range.firstRow() - 1); row <= lastRow; row++) {
            for (int column = Math.max(0, range.firstColumn() - 1); column <= lastColumn; column++) {
                Vector3d at = new Vector3d(
                        field.x(column) - frame.anchor().x(),
                        field.y(field.height(column, row)) - frame.anchor().y(),
                        field.z(row) - frame.anchor().z());
                frame.mapFromAnchor().transformPosition(at);
                ends[0] = Math.min(ends[0], at.x);
                ends[1] = Math.min(ends[1], at.y);
                ends[2] = Math.max(ends[2], at.x);
                ends[3] = Math.max(ends[3], at.y);
            }
        }
    }

    private static ShadowPart of(ShadowFrame frame, double[] ends) {
        int left = texel(ends[0], frame.width(), -MARGIN_TEXELS);
        int bottom = texel(ends[1], frame.height(), -MARGIN_TEXELS);
        int right = texel(ends[2], frame.width(), 1 + MARGIN_TEXELS);
        int top = texel(ends[3], frame.height(), 1 + MARGIN_TEXELS);
        Texture.Region texels = new Texture.Region(left, bottom, Math.max(0, right - left), Math.max(0, top - bottom));
        double width = Math.max(texels.width(), 1) / (double) frame.width();
        double height = Math.max(texels.height(), 1) / (double) frame.height();
        Matrix4d part = new Matrix4d()
                .translation(-1, -1, -1)
                .scale(2 / width, 2 / height, 2)
                .translate(-left / (double) frame.width(), -bottom / (double) frame.height(), 0)
                .mul(frame.mapFromAnchor());
        Vec3 anchor = frame.anchor();
        return new ShadowPart(texels, Frustum.of(part, anchor));
    }

    private static int texel(double share, int texels, int more) {
        int border = ShadowFrame.BORDER_TEXELS;
        return (int) Math.max(border, Math.min(Math.floor(share * texels) + more, texels - border));
    }
}
