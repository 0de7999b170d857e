package nephele.editor.window.file;

import nephele.editor.text.Text;
import nephele.editor.text.Words;

/** A text of the dialogues about files in English, Brazilian and European Portuguese. */
enum FileDialogText implements Text {
    RECOVER_TITLE("Recover lost work", "Recuperar trabalho perdido", "Recuperar trabalho perdido"),
    RECOVER_INTRO(
            "The editor ended before these levels were saved:",
            "O editor terminou antes de estas fases serem salvas:",
            "O editor terminou antes de estes níveis serem guardados:"),
    RECOVER("Recover", "Recuperar", "Recuperar"),
    DISCARD("Discard", "Descartar", "Descartar"),
    LATER("Later", "Depois", "Mais tarde"),
    DISCARD_QUESTION(
            "Delete the lost work on %s for good?",
            "Apagar de vez o trabalho perdido em %s?", "Apagar de vez o trabalho perdido em %s?"),
    NOTHING_LOST("There is no lost work", "Não há trabalho perdido", "Não há trabalho perdido"),
    LOST_WORK("Lost work", "Trabalho perdido", "Trabalho perdido"),
    BACKUPS_TITLE("Backups of %s", "Cópias de segurança de %s", "Cópias de segurança de %s"),
    BACKUPS_INTRO(
            "Each save keeps the version before it, up to 50:",
            "Cada salvamento mantém a versão anterior, até 50:",
            "Cada gravação mantém a versão anterior, até 50:"),
    NO_BACKUPS(
            "There is no backup yet: the first one is made when a save replaces a version",
            "Ainda não há cópia de segurança: a primeira é feita quando uma versão é substituída",
            "Ainda não há cópia de segurança: a primeira é feita quando uma versão é substituída"),
    VERSIONS("Versions", "Versões", "Versões"),
    RESTORE("Restore", "Restaurar", "Repor"),
    OPEN_COPY("Open as Copy", "Abrir como cópia", "Abrir como cópia"),
    CLOSE("Close", "Fechar", "Fechar"),
    PICTURE_OF("Picture of %s", "Imagem de %s", "Imagem de %s"),
    NO_PICTURE("No picture", "Sem imagem", "Sem imagem");

    private final Words words;

    FileDialogText(String english, String brazilian, String european) {
        words = Words.of(english, brazilian, european);
    }

    @Override
    public Words words() {
        return words;
    }
}
