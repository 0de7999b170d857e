package nephele.editor.tool.select;

import java.util.List;
import nephele.editor.mark.Mark;
import nephele.editor.mark.MarkColour;
import nephele.editor.tool.Pointer;
import nephele.engine.math.Vec3;

/** The rectangle between two places of the pointer, as marks just before the camera. */
final class SelectionRectangle {
    private SelectionRectangle() {}

    static List<Mark> marks(Pointer a, Pointer b) {
        Vec3 first = at(b, a.x(), a.y());
        Vec3 second = at(b, b.x(), a.y());
        Vec3 third = at(b, b.x(), b.y());
        Vec3 fourth = at(b, a.x(), b.y());
        return List.of(line(first, second), line(second, third), line(third, fourth), line(fourth, first));
    }

    private static Vec3 at(Pointer pointer, double x, double y) {
        return pointer.camera().ray(x, y, pointer.size()).at(pointer.isPlan() ? 2e7 : 1);
    }

    private static Mark line(Vec3 from, Vec3 to) {
        return new Mark.Line(from, to, MarkColour.PREVIEW, Mark.Visibility.ALWAYS);
    }
}
