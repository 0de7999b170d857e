package nephele.editor.file;

import java.util.List;
import java.util.Optional;
import nephele.editor.added.NewRecord;
import nephele.editor.document.Document;
import nephele.editor.document.Selection;
import nephele.editor.document.Selection.FaceRef;
import nephele.editor.document.Snapshot;
import nephele.editor.record.Entities;
import nephele.editor.record.EntityRef;
import nephele.editor.record.RecordKind;
import nephele.editor.session.EditorSession;
import nephele.editor.text.Words;
import nephele.editor.tool.paint.PaintTool;
import nephele.engine.level.Cloud;
import nephele.engine.level.CloudTechnique;
import nephele.engine.level.Level;
import nephele.engine.level.Material;
import nephele.engine.level.ModelPlacement;
import nephele.engine.level.Solid;
import nephele.engine.level.Terrain;
import nephele.engine.math.Vec3;

/** Puts an asset to use in the level, each time as one step. */
final class AssetUse {
    private static final String MATERIALS = "materials";

    private final EditorSession session;
    private final Entities entities;
    private final String asset;

    AssetUse(EditorSession session, String asset) {
        this.session = session;
        this.asset = asset;
        entities = session.document().entities();
    }

    /** Makes a material of a picture, unless there is one, and paints a face with it; new brushes get it, too. */
    void picture(Optional<FaceRef> face) {
        Document document = session.document();
        Optional<String> known = document.level().materials().stream()
                .filter(material -> asset.equals(material.texture()))
                .map(Material::id)
                .findFirst();
        String id = known.orElseGet(() -> freshId(MATERIALS));
        session.options().material(id);
        document.edit(FileText.ADD_PICTURE.words(), null, before -> {
            Level level = known.isPresent() ? before.level() : added(before.level(), MATERIALS, material(id));
            return face.isPresent() ? before.with(painted(level, face.get(), id)) : selected(level, MATERIALS, id);
        });
    }

    private Material material(String id) {
        return new Material(id, new Vec3(1, 1, 1), asset, null, null, null, Vec3.ZERO, 1);
    }

    private Level painted(Level level, FaceRef face, String material) {
        return (Level) entities.changed(level, List.of(face.solid()), solid ->
                (Record) PaintTool.withFace((Solid) solid, face.face(), material));
    }

    void model(Vec3 at) {
        String id = freshId("models");
        List<ModelPlacement.TransformStep> steps =
                at.equals(Vec3.ZERO) ? List.of() : List.of(new ModelPlacement.TransformStep.Translate(at));
        add(FileText.ADD_MODEL.words(), "models", id, new ModelPlacement(id, asset, null, steps, null, false));
    }

    void terrain(Vec3 at) {
        String id = freshId("terrains");
        Terrain made = (Terrain) NewRecord.at(RecordKind.of(Terrain.class), id, at);
        add(FileText.ADD_TERRAIN.words(), "terrains", id, made.withHeightMap(asset));
    }

    /** @param base the middle of the lower side */
    void cloud(Vec3 base, Vec3 size) {
        String section = "environment.clouds";
        String id = freshId(section);
        Vec3 centre = base.plus(new Vec3(0, size.y() / 2, 0));
        Cloud cloud = new Cloud(
                id,
                new Cloud.Extent.Volume(centre, size),
                CloudTechnique.AUTO,
                new Cloud.Density.Grid(asset),
                0.05,
                1,
                0);
        add(FileText.ADD_CLOUD.words(), section, id, cloud);
    }

    private void add(Words label, String section, String id, Record entity) {
        session.document().edit(label, null, before -> selected(added(before.level(), section, entity), section, id));
    }

    private Level added(Level level, String section, Record entity) {
        return (Level) entities.added(level, section, entity);
    }

    private static Snapshot selected(Level level, String section, String id) {
        return new Snapshot(level, Selection.of(new EntityRef(section, id)));
    }

    /** Returns an id after the file's name that the section does not have. */
    private String freshId(String section) {
        String name = asset.substring(asset.lastIndexOf('/') + 1);
        int dot = name.lastIndexOf('.');
        return entities.freshId(session.document().level(), section, dot < 0 ? name : name.substring(0, dot));
    }
}
