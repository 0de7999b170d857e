package nephele.editor.file;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.DoubleStream;
import nephele.editor.added.AddedRecord;
import nephele.editor.document.Clip;
import nephele.editor.document.Document;
import nephele.editor.document.NoteEdits;
import nephele.editor.document.Selection;
import nephele.editor.document.Selection.FaceRef;
import nephele.editor.document.Snapshot;
import nephele.editor.record.Entities;
import nephele.editor.record.EntityRef;
import nephele.editor.record.RecordKind;
import nephele.editor.session.EditorSession;
import nephele.editor.text.EditorRefusal;
import nephele.editor.text.Words;
import nephele.editor.tool.paint.PaintTool;
import nephele.engine.asset.AssetException;
import nephele.engine.asset.AssetId;
import nephele.engine.asset.AtomicFile;
import nephele.engine.asset.HeightMap;
import nephele.engine.asset.PictureDecoder;
import nephele.engine.asset.VoxelGrid;
import nephele.engine.level.Cloud;
import nephele.engine.level.CloudTechnique;
import nephele.engine.level.Level;
import nephele.engine.level.Material;
import nephele.engine.level.ModelPlacement;
import nephele.engine.level.Solid;
import nephele.engine.level.Terrain;
import nephele.engine.level.json.LevelFile;
import nephele.engine.level.json.LevelFormatException;
import nephele.engine.level.json.LevelJson;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;
import nephele.engine.model.ModelFileException;
import nephele.engine.model.file.ModelFiles;

/** A file that a user drops on the editor: it is opened, or becomes an asset of the level with what uses it. */
public final class DroppedFile {
    private static final String MATERIALS = "materials";
    private static final double LEAST_CLOUD_METRES = 0.1;
    private static final double LARGEST_CLOUD_METRES = 1e5;

    /** The kind of a file by its ending. */
    public enum Kind {
        PICTURE("png", "jpg", "jpeg", "bmp", "tga"),
        MODEL("3d", "obj", "gltf", "glb"),
        CLOUD("vol"),
        HEIGHTS("r16"),
        SCENE("xml"),
        LEVEL("json", "zip");

        private final List<String> endings;

        Kind(String... endings) {
            this.endings = List.of(endings);
        }

        /** Returns the endings of file names, in lower case without the dot. */
        public List<String> endings() {
            return endings;
        }

        /** Returns the kind of a file. */
        public static Kind of(Path file) throws EditorRefusal {
            String name = file.getFileName() == null ? "" : file.getFileName().toString();
            String ending = name.substring(name.lastIndexOf('.') + 1).toLowerCase(Locale.ROOT);
            for (Kind kind : values()) {
                if (kind.endings.contains(ending) && name.contains(".") && !Files.isDirectory(file)) {
                    return kind;
                }
            }
            throw new EditorRefusal(FileText.UNKNOWN_KIND.with(file));
        }

        /** Returns true if the open level is left for another one; a scene is {@linkplain SceneUse used} in two ways. */
        public boolean replacesLevel() {
            return this == LEVEL;
        }
    }

    /** What becomes of an XML scene. */
    public enum SceneUse {
        /** Its entities join the open level. */
        INSERT,
        /** It is opened in place of the open level. */
        REPLACE
    }

    private final EditorSession session;
    private final Path file;

    public DroppedFile(EditorSession session, Path file) {
        this.session = session;
        this.file = file;
    }

    /** Returns true if the open level is a new one without changes, in place of which a scene can be opened unasked. */
    public static boolean isUntouched(EditorSession session) {
        return session.file().path().isEmpty() && !session.document().isModified();
    }

    /**
     * Uses the file.
     *
     * @param at metres; where models and clouds appear
     * @param face what a picture is painted on; empty for nothing
     * @param use what becomes of a scene
     * @throws EditorRefusal if it can't be used; level and folder are then as before
     */
    public void dropOn(Vec3 at, Optional<FaceRef> face, SceneUse use) throws EditorRefusal {
        switch (Kind.of(file)) {
            case PICTURE -> picture(face);
            case MODEL -> model(at);
            case CLOUD -> cloud(at);
            case HEIGHTS -> heights(at);
            case SCENE -> {
                if (use == SceneUse.INSERT) {
                    insertScene(at);
                } else {
                    openScene();
                }
            }
            case LEVEL -> LevelOpening.open(session, file.toString());
        }
    }

    private byte[] content() throws EditorRefusal {
        return session.background().get(() -> AssetFolder.read(file));
    }

    private void picture(Optional<FaceRef> face) throws EditorRefusal {
        AssetFolder folder = AssetFolder.of(session, file);
        byte[] content = content();
        try {
            session.background()
                    .get(() -> PictureDecoder.decode(file.getFileName().toString(), content));
        } catch (AssetException noPicture) {
            throw refused(noPicture);
        }
        if (face.isPresent()) {
            EntityRef solid = face.get().solid();
            if (NoteEdits.unlocked(session.document().level(), List.of(solid)).isEmpty()) {
                throw new EditorRefusal(NoteEdits.LOCKED.with(solid.text()));
            }
        }
        String id = folder.idOf(file, content, "textures");
        addPicture(id, face);
        session.status(FileText.ADDED.with(file.getFileName(), id));
    }

    private void model(Vec3 at) throws EditorRefusal {
        AssetFolder folder = AssetFolder.of(session, file);
        byte[] content = content();
        String id = folder.idOf(file, content, "models", session.background().get(() -> neighbours(content)));
        addModel(id, at);
        session.status(FileText.ADDED.with(file.getFileName(), id));
    }

    /** Reads the model as the engine will, and returns the files that it names beside itself. */
    private Map<String, byte[]> neighbours(byte[] content) throws EditorRefusal {
        Map<String, byte[]> neighbours = new LinkedHashMap<>();
        List<EditorRefusal> missing = new ArrayList<>();
        try {
            ModelFiles.read(file.getFileName().toString(), content, name -> {
                ModelFiles.requireName(name, AssetId.rejectionReason(name));
                try {
                    byte[] read = AssetFolder.read(file.resolveSibling(name));
                    neighbours.put(name, read);
                    return read;
                } catch (EditorRefusal refusal) {
                    missing.add(refusal);
                    throw new ModelFileException(name, 0, "is missing", "put it beside the model");
                }
            });
        } catch (ModelFileException | AssetException | IllegalArgumentException noModel) {
            throw missing.isEmpty() ? refused(noModel) : missing.get(0);
        }
        return neighbours;
    }

    private EditorRefusal refused(RuntimeException reason) {
        return new EditorRefusal(FileText.UNUSABLE.with(file, reason.getMessage()));
    }

    private void cloud(Vec3 at) throws EditorRefusal {
        AssetFolder folder = AssetFolder.of(session, file);
        byte[] content = content();
        Vec3 size = sizeMetres(grid(content));
        String id = folder.idOf(file, content, "clouds");
        addCloud(id, at, size);
        session.status(FileText.ADDED.with(file.getFileName(), id));
    }

    private void heights(Vec3 at) throws EditorRefusal {
        AssetFolder folder = AssetFolder.of(session, file);
        byte[] content = content();
        try {
            session.background().get(() -> HeightMap.read(file.getFileName().toString(), content));
        } catch (AssetException noHeights) {
            throw refused(noHeights);
        }
        String id = folder.idOf(file, content, "terrain");
        addTerrain(id, at);
        session.status(FileText.ADDED.with(file.getFileName(), id));
    }

    private VoxelGrid grid(byte[] content) throws EditorRefusal {
        try {
            return session.background().get(() -> VoxelGrid.read(String.valueOf(file.getFileName()), content));
        } catch (AssetException noGrid) {
            throw refused(noGrid);
        }
    }

    /** Returns the size of a grid's own box, or one of 40 m if that is no size of a cloud. */
    private static Vec3 sizeMetres(VoxelGrid grid) {
        Aabb box = grid.box();
        Vec3 size = new Vec3(box.maxX() - box.minX(), box.maxY() - box.minY(), box.maxZ() - box.minZ());
        boolean isUsual = DoubleStream.of(size.x(), size.y(), size.z())
                .allMatch(edge -> edge >= LEAST_CLOUD_METRES && edge <= LARGEST_CLOUD_METRES);
        return isUsual ? size : new Vec3(40, 40, 40);
    }

    /** Imports the scene beside the level, whose files its pictures and meshes then are, and adds its entities. */
    private void insertScene(Vec3 at) throws EditorRefusal {
        Path own = session.file()
                .path()
                .orElseThrow(() -> new EditorRefusal(FileText.SAVE_FIRST.with(file.getFileName())));
        Path imported = LevelOpening.fresh(own.resolveSibling(stem()), ".json");
        List<String> complaints = new ArrayList<>();
        session.background().get(() -> {
            session.fileServices().scenes().save(file, imported, complaints::add);
            return null;
        });
        Document document = session.document();
        try {
            Level scene = withOwnMaterials(session.background().get(() -> LevelFile.read(imported)), document.level());
            Snapshot after = Clip.pasted(document.now(), LevelJson.write(scene), at);
            document.edit(FileText.ADD_SCENE.words(), null, before -> after);
            Files.deleteIfExists(imported);
        } catch (LevelFormatException noLevel) {
            throw new EditorRefusal(Words.same(noLevel.getMessage()));
        } catch (IOException stays) {
            complaints.add(imported + ": " + AtomicFile.reason(stays));
        }
        session.status(
                complaints.isEmpty() ? FileText.INSERTED.with(file.getFileName()) : Words.same(complaints.get(0)));
    }

    /** Returns a scene whose materials have names that the level has for no other material. */
    private static Level withOwnMaterials(Level scene, Level level) {
        Level result = scene;
        for (Material material : scene.materials()) {
            boolean isOther = level.materials().stream()
                    .anyMatch(known -> known.id().equals(material.id()) && !known.equals(material));
            if (isOther) {
                Set<String> taken = new HashSet<>();
                result.materials().forEach(each -> taken.add(each.id()));
                String id = Entities.LEVEL.freshId(level, MATERIALS, material.id(), taken);
                result = Entities.LEVEL.renamed(result, new EntityRef(MATERIALS, material.id()), id);
            }
        }
        return result;
    }

    private String stem() {
        String name = file.getFileName().toString();
        return name.substring(0, name.length() - 4);
    }

    private void openScene() throws EditorRefusal {
        Path beside = session.file().path().orElse(file.toAbsolutePath());
        Path level = LevelOpening.fresh(beside.resolveSibling(stem()), ".json");
        List<String> complaints = new ArrayList<>();
        session.background().get(() -> {
            session.fileServices().scenes().save(file, level, complaints::add);
            return null;
        });
        LevelOpening.open(session, level.toString());
        session.status(complaints.isEmpty() ? FileText.IMPORTED.with(level) : Words.same(complaints.get(0)));
    }

    /** Makes a material of a picture, unless there is one, and paints a face with it; new brushes get it, too. */
    private void addPicture(String asset, Optional<FaceRef> face) {
        Document document = session.document();
        Optional<String> known = document.level().materials().stream()
                .filter(material -> asset.equals(material.texture()))
                .map(Material::id)
                .findFirst();
        String id = known.orElseGet(() -> freshId(MATERIALS, asset));
        session.options().material(id);
        document.edit(FileText.ADD_PICTURE.words(), null, before -> {
            Level level = known.isPresent() ? before.level() : added(before.level(), MATERIALS, material(id, asset));
            return face.isPresent() ? before.with(painted(level, face.get(), id)) : selected(level, MATERIALS, id);
        });
    }

    private static Material material(String id, String asset) {
        return new Material(id, new Vec3(1, 1, 1), asset, null, null, null, Vec3.ZERO, 1);
    }

    private static Level painted(Level level, FaceRef face, String material) {
        return Entities.LEVEL.changed(level, List.of(face.solid()), solid ->
                (Record) PaintTool.withFace((Solid) solid, face.face(), material));
    }

    private void addModel(String asset, Vec3 at) {
        String id = freshId("models", asset);
        List<ModelPlacement.TransformStep> steps =
                at.equals(Vec3.ZERO) ? List.of() : List.of(new ModelPlacement.TransformStep.Translate(at));
        add(FileText.ADD_MODEL.words(), "models", id, new ModelPlacement(id, asset, null, steps, null, false));
    }

    private void addTerrain(String asset, Vec3 at) {
        String id = freshId("terrains", asset);
        Terrain made = (Terrain) AddedRecord.at(RecordKind.of(Terrain.class), id, at);
        add(FileText.ADD_TERRAIN.words(), "terrains", id, made.withHeightMap(asset));
    }

    /** @param base the middle of the lower side */
    private void addCloud(String asset, Vec3 base, Vec3 size) {
        String section = "environment.clouds";
        String id = freshId(section, asset);
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

    private static Level added(Level level, String section, Record entity) {
        return Entities.LEVEL.added(level, section, entity);
    }

    private static Snapshot selected(Level level, String section, String id) {
        return new Snapshot(level, Selection.of(new EntityRef(section, id)));
    }

    /** Returns an id after the file's name that the section does not have. */
    private String freshId(String section, String asset) {
        String name = asset.substring(asset.lastIndexOf('/') + 1);
        int dot = name.lastIndexOf('.');
        return Entities.LEVEL.freshId(session.document().level(), section, dot < 0 ? name : name.substring(0, dot));
    }
}
