package nephele.editor.save;

import nephele.editor.text.Text;
import nephele.editor.text.Words;

/** A message about files, in English, Brazilian and European Portuguese; {@code %s} stand for files and reasons. */
public enum SaveText implements Text {
    READ_ONLY(
            "%s is read-only: nothing was saved. Save under another name, or permit writing to the file and save"
                    + " again.",
            "%s é somente leitura: nada foi salvo. Salve com outro nome, ou permita a gravação no arquivo e salve de"
                    + " novo.",
            "%s é só de leitura: nada foi guardado. Guarda com outro nome, ou permite a escrita no ficheiro e guarda de"
                    + " novo."),
    ACCESS_DENIED(
            "Access to %s is denied: nothing was saved. Save to a folder of your own.",
            "O acesso a %s foi negado: nada foi salvo. Salve em uma pasta sua.",
            "O acesso a %s foi negado: nada foi guardado. Guarda numa pasta tua."),
    ASSET_TAKEN(
            "%s is another file than the one of that name that the level uses: nothing was saved. Save to another"
                    + " folder.",
            "%s é outro arquivo, não o desse nome que a fase usa: nada foi salvo. Salve em outra pasta.",
            "%s é outro ficheiro, não o desse nome que o nível usa: nada foi guardado. Guarda noutra pasta."),
    FOLDER_MISSING(
            "The folder %s is missing: nothing was saved. Save elsewhere, or make the folder again and save.",
            "A pasta %s não existe: nada foi salvo. Salve em outro lugar, ou crie a pasta de novo e salve.",
            "A pasta %s não existe: nada foi guardado. Guarda noutro lugar, ou cria a pasta de novo e guarda."),
    DISK_FULL(
            "The disk of %s is full: nothing was saved. Make room on it and save again, or save elsewhere.",
            "O disco de %s está cheio: nada foi salvo. Libere espaço e salve de novo, ou salve em outro lugar.",
            "O disco de %s está cheio: nada foi guardado. Liberta espaço e guarda de novo, ou guarda noutro lugar."),
    IS_FOLDER(
            "%s is a folder: nothing was saved. Choose the name of a file.",
            "%s é uma pasta: nada foi salvo. Escolha um nome de arquivo.",
            "%s é uma pasta: nada foi guardado. Escolhe um nome de ficheiro."),
    NO_LEVEL_FILE(
            "The level cannot be a file as it is: nothing was saved. Correct this first: %s",
            "A fase não pode ser um arquivo como está: nada foi salvo. Corrija isto primeiro: %s",
            "O nível não pode ser um ficheiro como está: nada foi guardado. Corrige isto primeiro: %s"),
    NOT_SAVED(
            "%s cannot be saved (%s). The version on disk is unchanged: save again, or under another name.",
            "%s não pode ser salvo (%s). A versão no disco não mudou: salve de novo, ou com outro nome.",
            "%s não pode ser guardado (%s). A versão no disco não mudou: guarda de novo, ou com outro nome."),
    CHANGED_OUTSIDE(
            "Another program has changed %s since it was opened. Replace it by your version, save under another name,"
                    + " or open the file again?",
            "Outro programa alterou %s desde que foi aberto. Substituir pela sua versão, salvar com outro nome ou abrir"
                    + " o arquivo de novo?",
            "Outro programa alterou %s desde que foi aberto. Substituir pela tua versão, guardar com outro nome ou"
                    + " abrir o ficheiro de novo?"),
    DELETED_OUTSIDE(
            "%s was deleted or moved while it was open. Save it there again, or under another name?",
            "%s foi apagado ou movido enquanto estava aberto. Salvar ali de novo ou com outro nome?",
            "%s foi apagado ou movido enquanto estava aberto. Guardar ali de novo ou com outro nome?"),
    NO_BACKUP(
            "Saved, but the version before has no backup: %s (%s)",
            "Salvo, mas a versão anterior ficou sem cópia de segurança: %s (%s)",
            "Guardado, mas a versão anterior ficou sem cópia de segurança: %s (%s)"),
    NOT_RECORDED(
            "Your edits cannot be recorded in %s (%s): a crash would lose them. Save the level now.",
            "Suas edições não podem ser registradas em %s (%s): uma falha as perderia. Salve a fase agora.",
            "As tuas edições não podem ser registadas em %s (%s): com uma falha, perdem-se. Guarda o nível agora."),
    PACKAGE_ASSET(
            "%s was not written: the level names %s. Correct the name or add the file, then export again.",
            "%s não foi gravado: a fase indica %s. Corrija o nome ou acrescente o arquivo e exporte de novo.",
            "%s não foi escrito: o nível indica %s. Corrige o nome ou acrescenta o ficheiro e exporta de novo."),
    PACKAGE_UNREADABLE(
            "%s cannot be opened (%s). Choose a .zip that the editor exported.",
            "%s não pode ser aberto (%s). Escolha um .zip exportado pelo editor.",
            "%s não pode ser aberto (%s). Escolhe um .zip exportado pelo editor."),
    PACKAGE_ENTRY(
            "%s was not opened because of its entry %s: %s. Ask its author for a new export.",
            "%s não foi aberto por causa da entrada %s: %s. Peça ao autor uma nova exportação.",
            "%s não foi aberto por causa da entrada %s: %s. Pede ao autor uma nova exportação."),
    PACKAGE_TARGET(
            "%s exists already and is not empty: nothing was written. Choose a new folder.",
            "%s já existe e não está vazia: nada foi gravado. Escolha uma pasta nova.",
            "%s já existe e não está vazia: nada foi escrito. Escolhe uma pasta nova.");

    private final Words words;

    SaveText(String english, String brazilian, String european) {
        words = Words.of(english, brazilian, european);
    }

    @Override
    public Words words() {
        return words;
    }
}
