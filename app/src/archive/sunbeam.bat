@echo off
rem Starts Sunbeam on Windows.
setlocal
set JAVA=java
rem A path may hold blanks and signs that have a meaning here, and quotes of its own.
if defined JAVA_HOME set "JAVA=%JAVA_HOME:"=%\bin\java"
"%JAVA%" -version >nul 2>&1
if errorlevel 1 (
    echo sunbeam: there is no Java: install Java 17 or newer, or set JAVA_HOME 1>&2
    exit /b 7
)
"%JAVA%" -XX:+DisplayVMOutputToStderr --enable-native-access=ALL-UNNAMED -Dfile.encoding=UTF-8 -XX:MaxRAMPercentage=50 %SUNBEAM_JAVA_OPTIONS% -cp "%~dp0lib\*" sunbeam.app.Main %*
