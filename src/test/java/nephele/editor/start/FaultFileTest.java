package nephele.editor.start;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import nephele.editor.text.Words;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class FaultFileTest {
    private static final IllegalStateException FAULT = new IllegalStateException("torn");

    @TempDir
    Path folder;

    @Test
    void aFaultIsWrittenToTheFileAndToldInOneLineThatNamesIt() throws Exception {
        Path file = folder.resolve("editor/fault.txt");
        String line = told(file);
        String text = Files.readString(file);
        assertTrue(text.contains("IllegalStateException: torn") && text.contains("FaultFileTest"), text);
        assertTrue(line.contains(file.toString()), line);
        assertFalse(line.contains("\n"), line);
    }

    @Test
    void whereTheFileCannotBeWrittenTheFaultItselfIsTold() throws Exception {
        String line = told(Files.writeString(folder.resolve("taken"), "").resolve("fault.txt"));
        assertTrue(line.contains("torn"), line);
    }

    private static String told(Path file) {
        List<Words> told = new ArrayList<>();
        new FaultFile(file, told::add).uncaughtException(Thread.currentThread(), FAULT);
        assertEquals(1, told.size());
        return told.get(0).english();
    }
}
