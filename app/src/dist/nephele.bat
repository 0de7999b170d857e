@echo off
rem Starts Nephele on Windows: a double click plays, "nephele --help" lists the commands.
setlocal
set java=java
if defined JAVA_HOME set "java=%JAVA_HOME%\bin\java"
rem Loads the main class without starting it, which no Java before 17 can.
"%java%" --dry-run -jar "%~dp0nephele.jar" >nul 2>nul
if errorlevel 1 goto :nojava
set arguments=%*
if "%~1"=="" set arguments=play
"%java%" -XX:+UseSerialGC -Xms512m -Xmn8m -jar "%~dp0nephele.jar" %arguments%
exit /b %errorlevel%

:nojava
echo nephele: needs Java 17 or newer: install it, or set JAVA_HOME to where it is
if "%~1"=="" pause
exit /b 3
