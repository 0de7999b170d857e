package nephele.editor.tool.extrude;

import java.util.ArrayList;
import java.util.List;
import nephele.editor.document.Notes;
import nephele.editor.document.Selection;
import nephele.editor.document.Selection.FaceRef;
import nephele.editor.pick.Picker;
import nephele.editor.record.EntityRef;
import nephele.editor.tool.ToolContext;
import nephele.engine.level.Brush;
import nephele.engine.level.Brush.BrushFace;
import nephele.engine.math.Plane;
import nephele.engine.math.Vec3;

/**
 * A face that an extrusion moves.
 *
 * @param index in the order of {@code Brush.faces()}
 */
record MovedFace(EntityRef solid, int index, List<Vec3> polygon) {
    private static final double SAME_PLANE_METRES = 1e-6;
    private static final double SAME_NORMAL = 1e-9;

    /** Returns a face, and if it is selected those that are selected in its plane. */
    static List<MovedFace> with(ToolContext context, FaceUnderPointer face) {
        List<MovedFace> faces = new ArrayList<>();
        faces.add(new MovedFace(face.ref().solid(), face.index(), face.face().polygon()));
        Selection selection = context.document().selection();
        if (isSelected(selection, face.ref())) {
            for (Brush brush : context.shapes().brushes()) {
                if (brush != face.brush() && isFree(context, brush)) {
                    addInPlane(faces, selection, brush, face.face().plane());
                }
            }
        }
        return List.copyOf(faces);
    }

    private static boolean isSelected(Selection selection, FaceRef face) {
        return selection.faces().contains(face) || selection.contains(face.solid());
    }

    private static boolean isFree(ToolContext context, Brush brush) {
        EntityRef solid = new EntityRef(Picker.SOLIDS, brush.solidId());
        return !Notes.free(context.document().level(), List.of(solid)).isEmpty();
    }

    private static void addInPlane(List<MovedFace> faces, Selection selection, Brush brush, Plane plane) {
        EntityRef solid = new EntityRef(Picker.SOLIDS, brush.solidId());
        for (int i = 0; i < brush.faces().size(); i++) {
            BrushFace face = brush.faces().get(i);
            if (isSelected(selection, new FaceRef(solid, face.name())) && isSame(face.plane(), plane)) {
                faces.add(new MovedFace(solid, i, face.polygon()));
            }
        }
    }

    private static boolean isSame(Plane a, Plane b) {
        return a.normal().dot(b.normal()) > 1 - SAME_NORMAL
                && Math.abs(a.distance() - b.distance()) < SAME_PLANE_METRES;
    }
}
