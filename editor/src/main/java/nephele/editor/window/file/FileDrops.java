package nephele.editor.window.file;

import java.awt.Component;
import java.awt.Point;
import java.awt.datatransfer.DataFlavor;
import java.awt.datatransfer.Transferable;
import java.awt.datatransfer.UnsupportedFlavorException;
import java.awt.dnd.DnDConstants;
import java.awt.dnd.DropTarget;
import java.awt.dnd.DropTargetAdapter;
import java.awt.dnd.DropTargetDragEvent;
import java.awt.dnd.DropTargetDropEvent;
import java.awt.dnd.DropTargetListener;
import java.io.File;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import java.util.function.Function;
import javax.swing.SwingUtilities;
import nephele.editor.document.Selection.FaceRef;
import nephele.editor.file.DroppedFile;
import nephele.editor.file.DroppedFile.Kind;
import nephele.editor.file.DroppedFile.SceneUse;
import nephele.editor.session.EditorSession;
import nephele.editor.text.EditorRefusal;
import nephele.editor.text.Words;
import nephele.editor.tool.FacesUnderPointer;
import nephele.editor.tool.PointedPlace;
import nephele.editor.tool.Pointer;
import nephele.editor.window.viewport.ViewportPanel;
import nephele.engine.level.Language;
import nephele.engine.math.Vec3;

/** Takes files that are dropped on the window; those that can't be used are reported together. */
public final class FileDrops {
    private final EditorSession session;
    private final ViewportPanel viewport;
    private final BooleanSupplier mayLeave;
    private final Consumer<Words> refused;
    private final Function<Path, Optional<SceneUse>> sceneUse;

    /** Takes files of which scenes are inserted without a question. */
    public FileDrops(EditorSession session, ViewportPanel viewport, BooleanSupplier mayLeave, Consumer<Words> refused) {
        this(session, viewport, mayLeave, refused, scene -> Optional.of(SceneUse.INSERT));
    }

    /**
     * @param mayLeave false if the user wants to stay with the level that is open
     * @param refused receives what can't be used and why
     * @param sceneUse asks what to do with a scene; empty if the user cancels
     */
    FileDrops(
            EditorSession session,
            ViewportPanel viewport,
            BooleanSupplier mayLeave,
            Consumer<Words> refused,
            Function<Path, Optional<SceneUse>> sceneUse) {
        this.sceneUse = sceneUse;
        this.session = session;
        this.viewport = viewport;
        this.mayLeave = mayLeave;
        this.refused = refused;
    }

    /** Accepts drops on a component and all inside of it. */
    void accept(Component component) {
        DropTargetListener drops = new DropTargetAdapter() {
            @Override
            public void dragEnter(DropTargetDragEvent event) {
                if (!event.isDataFlavorSupported(DataFlavor.javaFileListFlavor)) {
                    event.rejectDrag();
                }
            }

            @Override
            public void drop(DropTargetDropEvent event) {
                if (!event.isDataFlavorSupported(DataFlavor.javaFileListFlavor)) {
                    event.rejectDrop();
                    return;
                }
                event.acceptDrop(DnDConstants.ACTION_COPY);
                List<Path> files = files(event.getTransferable());
                event.dropComplete(!files.isEmpty());
                Component surface = viewport.surface().component();
                Point at = SwingUtilities.convertPoint(
                        event.getDropTargetContext().getComponent(), event.getLocation(), surface);
                // The source waits until the drop is complete: questions come after it.
                SwingUtilities.invokeLater(() -> FileDrops.this.drop(files, at));
            }
        };
        component.setDropTarget(new DropTarget(component, DnDConstants.ACTION_COPY, drops));
    }

    private static List<Path> files(Transferable dropped) {
        try {
            List<?> files = (List<?>) dropped.getTransferData(DataFlavor.javaFileListFlavor);
            return files.stream().map(file -> ((File) file).toPath()).toList();
        } catch (UnsupportedFlavorException | IOException gone) {
            return List.of();
        }
    }

    /**
     * Uses files that were dropped.
     *
     * @param at in points of the viewport's surface; may be outside of it
     */
    public void drop(List<Path> files, Point at) {
        List<Words> refusals = new ArrayList<>();
        for (Path file : files) {
            try {
                drop(file, at);
            } catch (EditorRefusal refusal) {
                refusals.add(refusal.words());
            }
        }
        if (!refusals.isEmpty()) {
            refused.accept(Words.of(
                    joined(refusals, Language.EN), joined(refusals, Language.PT_BR), joined(refusals, Language.PT_PT)));
        }
    }

    private void drop(Path file, Point at) throws EditorRefusal {
        Kind kind = Kind.of(file);
        Optional<SceneUse> use = kind != Kind.SCENE || DroppedFile.isUntouched(session)
                ? Optional.of(SceneUse.REPLACE)
                : sceneUse.apply(file);
        boolean isReplaced = kind.replacesLevel() || kind == Kind.SCENE && use.equals(Optional.of(SceneUse.REPLACE));
        if (use.isPresent() && (!isReplaced || mayLeave.getAsBoolean())) {
            session.tool().cancel();
            boolean isInside = viewport.surface().component().contains(at);
            Optional<Pointer> pointer = isInside ? viewport.pointer(at) : Optional.empty();
            Optional<FaceRef> face = pointer.flatMap(each -> FacesUnderPointer.at(session.context(), each));
            Vec3 place = pointer.flatMap(each -> PointedPlace.under(session.context(), each))
                    .map(each -> each.snapped(session.context()).point())
                    .orElse(Vec3.ZERO);
            new DroppedFile(session, file).dropOn(place, face, use.get());
        }
    }

    private static String joined(List<Words> all, Language language) {
        List<String> lines = all.stream().map(words -> words.in(language)).toList();
        return String.join("\n", lines);
    }
}
