package nephele.editor.added;

import java.util.List;
import nephele.editor.document.EntityTransform;
import nephele.editor.record.Prototypes;
import nephele.editor.record.RecordKind;
import nephele.engine.level.BoxFace;
import nephele.engine.level.Environment.Lightning;
import nephele.engine.level.ModelPlacement;
import nephele.engine.level.Solid;
import nephele.engine.math.Vec3;

/** New records at a place: those of {@link Prototypes}, and the few that need more than their components' prototypes. */
public final class NewRecord {
    private static final double HALF_METRES = 0.5;

    private NewRecord() {}

    /** Returns a new record at a place, metres; a record without an id ignores it. */
    public static Record at(RecordKind kind, String id, Vec3 at) {
        Record record = Prototypes.make(kind, id, at);
        if (record instanceof ModelPlacement) {
            return at.equals(Vec3.ZERO) ? record : EntityTransform.moved(record, at);
        } else if (record instanceof Solid.Planes planes) {
            return cube(planes, at);
        }
        return record instanceof Lightning lightning ? above(lightning) : record;
    }

    /** Planes without a single one enclose nothing. */
    private static Record cube(Solid.Planes none, Vec3 at) {
        Vec3 centre = at.plus(new Vec3(0, HALF_METRES, 0));
        List<Solid.PlaneFace> planes = List.of(BoxFace.values()).stream()
                .map(side ->
                        new Solid.PlaneFace(side.normal(), side.normal().dot(centre) + HALF_METRES, null, null, null))
                .toList();
        return new Solid.Planes(none.id(), none.material(), none.portalable(), none.textureMapping(), planes);
    }

    /** Bolts end below the box in which they begin. */
    private static Record above(Lightning lightning) {
        double up = lightning.groundAltitudeMetres()
                + 2 * lightning.size().y()
                - lightning.centre().y();
        return up > 0 ? EntityTransform.moved(lightning, new Vec3(0, up, 0)) : lightning;
    }
}
