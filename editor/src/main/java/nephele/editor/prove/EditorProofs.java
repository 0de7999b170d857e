package nephele.editor.prove;

import java.util.List;
import nephele.lab.prove.proof.Proof;

/** The registry of the editor's proofs, in the order in which {@code prove} runs them after those of the lab. */
public final class EditorProofs {
    public static final List<Proof> ALL = List.of(
            new JournalKillProof(5),
            new EditorCommandsProof(),
            new EditorOpenSaveProof(),
            new EditorEventsProof(),
            new EditorStallsProof(),
            new EditorPicturesProof(1));

    private EditorProofs() {}
}
