package nephele.editor.tool.paint;

import static nephele.editor.tool.ToolTrial.FLOOR;
import static nephele.editor.tool.ToolTrial.WALL;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import nephele.editor.document.Selection;
import nephele.editor.document.Selection.FaceRef;
import nephele.editor.paint.PaintedFace;
import nephele.editor.paint.TextureFit;
import nephele.editor.record.EntityRef;
import nephele.editor.save.DraftLevel;
import nephele.editor.text.Words;
import nephele.editor.tool.FacesUnderPointer;
import nephele.editor.tool.Pointer.Modifier;
import nephele.editor.tool.ToolTrial;
import nephele.engine.level.Brush.BrushFace;
import nephele.engine.level.Level;
import nephele.engine.level.RoomLevel;
import nephele.engine.level.Solid;
import nephele.engine.level.TexturePlacement;
import nephele.engine.level.appearance.SolidFaces;
import nephele.engine.math.Vec3;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

/** The paint tool gives faces a material. */
@Execution(ExecutionMode.CONCURRENT)
class PaintToolTest {
    private static ToolTrial hall() {
        Level materials = DraftLevel.of("\"materials\": [{\"id\": \"brick\"}," + " {\"id\": \"stone\"}]");
        Level hall = RoomLevel.hall().level();
        ToolTrial trial = new ToolTrial(hall.with(materials.materials(), hall.solids()), PaintTool::new);
        trial.options().material("brick");
        return trial;
    }

    private static Solid solid(ToolTrial trial, int index) {
        return trial.level().solids().get(index);
    }

    private static String material(ToolTrial trial, int solid, String face) {
        return shape(trial, solid, face).material();
    }

    private static BrushFace shape(ToolTrial trial, int solid, String face) {
        FaceRef ref = new FaceRef(new EntityRef("solids", solid(trial, solid).id()), face);
        return FacesUnderPointer.shape(trial.level(), ref).orElseThrow();
    }

    @Test
    void theFaceThatIsClickedIsSelectedEvenIfItHasTheMaterialAlready() {
        ToolTrial trial = hall();
        FaceRef top = new FaceRef(new EntityRef("solids", solid(trial, 0).id()), "+y");
        for (int i = 0; i < 2; i++) {
            trial.document().select(Selection.NONE);
            trial.click(FLOOR);
            assertEquals(List.of(top), trial.document().selection().faces());
            assertEquals("brick", material(trial, 0, "+y"));
        }
    }

    @Test
    void aClickPaintsTheFaceAlone() {
        ToolTrial trial = hall();
        Level before = trial.level();
        trial.click(FLOOR);
        assertEquals(Map.of("+y", new Solid.Face("brick", null, null)), SolidFaces.authored(solid(trial, 0)));
        trial.assertOneSoundStep(before);
        Level painted = trial.level();
        trial.click(FLOOR);
        assertSame(painted, trial.level(), "nothing to change");
    }

    @Test
    void aDragIsOneStep() {
        ToolTrial trial = hall();
        Level before = trial.level();
        trial.drag(FLOOR, WALL);
        assertEquals("brick", material(trial, 0, "+y"));
        assertEquals("brick", material(trial, 4, "+z"));
        trial.assertOneSoundStep(before);
    }

    @Test
    void shiftPaintsTheWholeSolidAndGreyASingleFace() {
        ToolTrial trial = hall();
        trial.options().material("stone");
        trial.click(FLOOR);
        trial.options().material("brick");
        Level before = trial.level();
        trial.click(FLOOR, Modifier.SHIFT);
        assertEquals("brick", solid(trial, 0).material());
        assertEquals(Map.of(), SolidFaces.authored(solid(trial, 0)));
        trial.assertOneSoundStep(before);
        trial.options().material(null);
        trial.click(FLOOR);
        assertNull(material(trial, 0, "+y"));
        for (String face : List.of("+x", "-x", "-y", "+z", "-z")) {
            assertEquals("brick", material(trial, 0, face));
        }
    }

    @Test
    void altTakesTheMaterial() {
        ToolTrial trial = hall();
        trial.options().material("stone");
        trial.click(FLOOR);
        Level before = trial.level();
        trial.options().material("brick");
        trial.click(FLOOR, Modifier.ALT);
        assertEquals("stone", trial.options().material());
        trial.click(WALL, Modifier.ALT);
        assertNull(trial.options().material());
        assertSame(before, trial.level());
        assertEquals(List.of("Material: stone", "Material: grey"), trial.messages());
    }

    @Test
    void controlContinuesThePictureAcrossTheEdge() {
        ToolTrial trial = hall();
        trial.click(FLOOR);
        Solid turned = SolidFaces.with(
                solid(trial, 0), "+y", new Solid.Face("brick", null, new TexturePlacement(0.25, 0, 30, 2, 1)));
        Level level = trial.level();
        List<Solid> solids = new ArrayList<>(level.solids());
        solids.set(0, turned);
        trial.document().edit(Words.NONE, before -> level.with(level.materials(), solids));
        Level before = trial.level();
        trial.click(WALL, Modifier.CONTROL);
        trial.assertOneSoundStep(before);
        PaintedFace floor = face(trial, 0, "+y");
        PaintedFace wall = face(trial, 4, "+z");
        Vec3 edge = new Vec3(1.3, 0, -8);
        double u =
                TextureFit.uvAt(floor, edge).u() - TextureFit.uvAt(wall, edge).u();
        double v =
                TextureFit.uvAt(floor, edge).v() - TextureFit.uvAt(wall, edge).v();
        assertEquals(Math.rint(u), u, 1e-6);
        assertEquals(Math.rint(v), v, 1e-6);
    }

    private static PaintedFace face(ToolTrial trial, int solid, String name) {
        BrushFace face = shape(trial, solid, name);
        return PaintedFace.of(face, trial.level().materials().get(0));
    }

    @Test
    void escapeGivesTheLevelBack() {
        hall().assertCancelledDrag(FLOOR, WALL);
    }

    @Test
    void anUnknownMaterialIsTold() {
        ToolTrial trial = hall();
        trial.options().material("marble");
        trial.click(FLOOR);
        assertEquals(List.of("There is no material marble: choose another one"), trial.messages());
    }
}
