@echo off
rem Starts Sunbeam on Windows: without arguments, as by a double click, the viewer without a console; else a command.
rem A path may hold blanks and signs that have a meaning here, and quotes of its own: no variable is used outside of quotes, and none
rem in a block, whose parentheses a path could close.
setlocal DisableDelayedExpansion
set "java=java"
set "window=javaw"
if not defined JAVA_HOME goto bundled
set "java=%JAVA_HOME:"=%\bin\java"
set "window=%JAVA_HOME:"=%\bin\javaw"
:bundled
if not exist "%~dp0java\bin\java.exe" goto found
set "java=%~dp0java\bin\java"
set "window=%~dp0java\bin\javaw"
:found
"%java%" "@%~dp0lib\java.options" -version >nul 2>&1
if not errorlevel 1 goto start
echo sunbeam: there is no Java that will do: install Java 17 or newer, or set JAVA_HOME 1>&2
if "%~1"=="" pause
exit /b 7
:start
if "%~1"=="" goto window
rem Codes below 64 are Java's own: 130 after Ctrl-C, else those of a Java that dies, which Windows leaves unsaid.
"%java%" "@%~dp0lib\java.options" -Dsunbeam.exit=64 %SUNBEAM_JAVA_OPTIONS% -cp "%~dp0lib\*" sunbeam.app.Main %*
set code=%errorlevel%
if %code%==130 exit /b %code%
set /a code-=64
if %code% geq 0 exit /b %code%
echo sunbeam: Java has died, or has not begun: no result is whole 1>&2
exit /b 1
:window
start "" "%window%" "@%~dp0lib\java.options" -Dsunbeam.dialog=true %SUNBEAM_JAVA_OPTIONS% -cp "%~dp0lib\*" sunbeam.app.Main view
