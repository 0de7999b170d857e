package nephele.editor.draw;

import nephele.editor.pane.MarkColour;
import nephele.engine.math.Vec3;
import nephele.engine.render.line.LineCanvas;
import nephele.engine.render.line.LineColour;
import nephele.engine.render.line.LineLayer;

/** The grid on the plane y = 0 around the eye of a perspective pane. */
record FloorLines(Vec3 eye, double gridMetres, MarkPalette palette) {
    private static final int CELLS = 24;
    private static final int CELLS_PER_MAJOR = 8;
    private static final double MINOR_ALPHA = 0.28;
    private static final double MAJOR_ALPHA = 0.5;

    /** Adds the lines; their spacing grows with the eye's height. */
    void add(LineCanvas lines) {
        double least = Math.max(gridMetres, Math.abs(eye.y()) / CELLS);
        double cell = gridMetres * Math.pow(2, Math.ceil(Math.log(least / gridMetres) / Math.log(2)));
        cell = Math.max(cell, gridMetres * Math.pow(2, Math.ceil(Math.log(0.5 / gridMetres) / Math.log(2))));
        long middleX = Math.round(eye.x() / cell);
        long middleZ = Math.round(eye.z() / cell);
        double reach = 2.0 * CELLS * cell;
        LineColour grey = LineColour.of(0x8a949e, 1);
        for (long i = -2 * CELLS; i <= 2 * CELLS; i++) {
            double x = (middleX + i) * cell;
            double z = (middleZ + i) * cell;
            addLine(lines, new Vec3(x, 0, middleZ * cell), new Vec3(0, 0, reach), colour(middleX + i, grey, true));
            addLine(lines, new Vec3(middleX * cell, 0, z), new Vec3(reach, 0, 0), colour(middleZ + i, grey, false));
        }
    }

    private LineColour colour(long line, LineColour grey, boolean isAlongZ) {
        if (line == 0) {
            return palette.of(isAlongZ ? MarkColour.AXIS_Z : MarkColour.AXIS_X);
        }
        return grey.withAlpha(Math.floorMod(line, CELLS_PER_MAJOR) == 0 ? MAJOR_ALPHA : MINOR_ALPHA);
    }

    private static void addLine(LineCanvas lines, Vec3 middle, Vec3 half, LineColour colour) {
        lines.line(middle.minus(half), middle.plus(half), colour, 1, LineLayer.BEHIND_SURFACES);
    }
}
