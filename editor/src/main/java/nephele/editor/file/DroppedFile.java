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
import nephele.editor.document.Clip;
import nephele.editor.document.Document;
import nephele.editor.document.NoteEdits;
import nephele.editor.document.Selection.FaceRef;
import nephele.editor.document.Snapshot;
import nephele.editor.record.Entities;
import nephele.editor.record.EntityRef;
import nephele.editor.session.EditorSession;
import nephele.editor.text.EditorRefusal;
import nephele.editor.text.Words;
import nephele.engine.asset.AssetException;
import nephele.engine.asset.AssetId;
import nephele.engine.asset.AtomicFile;
import nephele.engine.asset.HeightMap;
import nephele.engine.asset.PictureDecoder;
import nephele.engine.asset.VoxelGrid;
import nephele.engine.level.Level;
import nephele.engine.level.Material;
import nephele.engine.level.json.LevelFile;
import nephele.engine.level.json.LevelFormatException;
import nephele.engine.level.json.LevelJson;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;
import nephele.engine.model.ModelFileException;
import nephele.engine.model.file.ModelFiles;

/** A file that a user drops on the editor: it is opened, or becomes an asset of the level with what uses it. */
public final class DroppedFile {
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

    /**
     * The place at which a file is dropped.
     *
     * @param at metres; where models and clouds appear
     * @param face what a picture is painted on; empty for nothing
     */
    public record Target(Vec3 at, Optional<FaceRef> face) {}

    private final EditorSession session;
    private final Path file;

    public DroppedFile(EditorSession session, Path file) {
        this.session = session;
        this.file = file;
    }

    /**
     * Uses the file.
     *
     * @throws EditorRefusal if it can't be used; level and folder are then as before
     */
    public void dropOn(Target target) throws EditorRefusal {
        dropOn(target, isUntouched(session) ? SceneUse.REPLACE : SceneUse.INSERT);
    }

    /** Returns true if the open level is a new one without changes, in place of which a scene can be opened unasked. */
    public static boolean isUntouched(EditorSession session) {
        return session.file().path().isEmpty() && !session.document().isModified();
    }

    /** Uses the file as {@link #dropOn(Target)}, a scene as it is said. */
    public void dropOn(Target target, SceneUse use) throws EditorRefusal {
        switch (Kind.of(file)) {
            case PICTURE -> picture(target);
            case MODEL -> model(target);
            case CLOUD -> cloud(target);
            case HEIGHTS -> heights(target);
            case SCENE -> {
                if (use == SceneUse.INSERT) {
                    insertScene(target.at());
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

    private void picture(Target target) throws EditorRefusal {
        AssetFolder folder = AssetFolder.of(session, file);
        byte[] content = content();
        try {
            session.background()
                    .get(() -> PictureDecoder.decode(file.getFileName().toString(), content));
        } catch (AssetException noPicture) {
            throw refused(noPicture);
        }
        if (target.face().isPresent()) {
            EntityRef solid = target.face().get().solid();
            if (NoteEdits.unlocked(session.document().level(), List.of(solid)).isEmpty()) {
                throw new EditorRefusal(NoteEdits.LOCKED.with(solid.text()));
            }
        }
        String id = folder.idOf(file, content, "textures");
        new AssetUse(session, id).picture(target.face());
        told(id);
    }

    private void model(Target target) throws EditorRefusal {
        AssetFolder folder = AssetFolder.of(session, file);
        byte[] content = content();
        String id = folder.idOf(file, content, "models", session.background().get(() -> neighbours(content)));
        new AssetUse(session, id).model(target.at());
        told(id);
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

    private void cloud(Target target) throws EditorRefusal {
        AssetFolder folder = AssetFolder.of(session, file);
        byte[] content = content();
        Vec3 size = sizeMetres(grid(content));
        String id = folder.idOf(file, content, "clouds");
        new AssetUse(session, id).cloud(target.at(), size);
        told(id);
    }

    private void heights(Target target) throws EditorRefusal {
        AssetFolder folder = AssetFolder.of(session, file);
        byte[] content = content();
        try {
            session.background().get(() -> HeightMap.read(file.getFileName().toString(), content));
        } catch (AssetException noHeights) {
            throw refused(noHeights);
        }
        String id = folder.idOf(file, content, "terrain");
        new AssetUse(session, id).terrain(target.at());
        told(id);
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
            Snapshot after = Clip.pasted(document.now(), LevelJson.write(scene), at, document.entities());
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
                String id = Entities.LEVEL.freshId(level, "materials", material.id(), taken);
                result = (Level) Entities.LEVEL.renamed(result, new EntityRef("materials", material.id()), id);
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

    private void told(String id) {
        session.status(FileText.ADDED.with(file.getFileName(), id));
    }
}
